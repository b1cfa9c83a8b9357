"""Lists the drones that you see, and what the first one tells of itself. Writes hello.json."""

from pathlib import Path

from dronemap import Dronemap

with Dronemap.connect() as server:
    for drone in server.drones():
        state = drone.state
        battery = state.battery.percent if state.battery else None
        print(f"{drone.name}: {state.link.state}, {state.mode}, armed: {state.armed}, battery: {battery} %")
    first = server.drones()[0]
    print(f"{first.name} is a {first.state.kind} with {first.state.autopilot}.")
    Path("hello.json").write_text(first.state.model_dump_json(by_alias=True, indent=2))
