"""Takes off, flies to two places one after the other, and returns home. Writes goto.csv: where it was, and when.

Each line ends when the drone is there, and whoever leaves the block early has it return home.
"""

import csv
from pathlib import Path

from dronemap import Dronemap, offset

with Dronemap.connect() as server:
    drone = server.drones()[0]
    drone.wait_for(lambda state: state.ready_to_arm is True and state.position is not None, timeout=60)
    begun = drone.state.last_update
    home = drone.state.position
    assert home is not None and home.latitude is not None and home.longitude is not None

    with drone.control() as pilot:
        print("Take off to 10 m")
        pilot.arm()
        pilot.take_off(10)
        print("50 m north, at 20 m")
        pilot.go_to(*offset(home.latitude, home.longitude, north=50), 20)
        print("50 m east, at 15 m")
        pilot.go_to(*offset(home.latitude, home.longitude, north=50, east=50), 15)
        print("Return home")
        pilot.return_home()

    table = drone.telemetry(since=begun)
    with Path("goto.csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(table)
        rows.writerows(zip(*table.values(), strict=True))
    print(f"goto.csv has {len(table.points)} points.")
