"""MAVSDK flies all vehicles that it finds: a program of its own, since it is a native library.

python -m dronemap_e2e.mavsdk_pilot URL COUNT prints what each was like, as JSON."""

import json
import math
import sys
import threading
from typing import Any

from mavsdk import ComponentType, Configuration, Mavsdk
from mavsdk.plugins.action import Action
from mavsdk.plugins.mission_raw import MissionItem, MissionRaw
from mavsdk.plugins.param import Param
from mavsdk.plugins.telemetry import Telemetry

from .waiting import wait_for

HEIGHT_METERS = 8.0
ITEMS = 5
WAYPOINT, ABOVE_HOME = 16, 3


class Vehicle:
    """One vehicle by its telemetry."""

    def __init__(self, system: Any) -> None:
        self.system_id = int(system.get_system_id())
        self._action = Action(system)
        self._params = Param(system)
        self._mission = MissionRaw(system)
        telemetry = Telemetry(system)
        self._telemetry = telemetry
        self._height = math.nan
        self._armed = False
        self._lock = threading.Lock()
        telemetry.subscribe_position(self._at)
        telemetry.subscribe_armed(self._is_armed)

    def _at(self, position: Any, *_: Any) -> None:
        self._height = position.relative_altitude_m

    def _is_armed(self, armed: Any, *_: Any) -> None:
        self._armed = bool(armed)

    def read(self) -> dict[str, int]:
        """Counts of its parameters and mission items."""
        every = self._params.get_all_params()
        counts = len(every.int_params) + len(every.float_params) + len(every.custom_params)
        return {"parameters": counts, "items": len(self._mission.download_mission())}

    def write(self, count: int) -> None:
        """A mission of a home and so many places, which it does not fly."""
        home = MissionItem(command=WAYPOINT, current=1, autocontinue=1, x=473977000, y=85456000)
        places = [
            MissionItem(
                seq=seq,
                frame=ABOVE_HOME,
                command=WAYPOINT,
                autocontinue=1,
                x=473977000 + seq,
                y=85456000,
                z=10,
            )
            for seq in range(1, count + 1)
        ]
        self._mission.upload_mission([home, *places])

    def take_off(self) -> None:
        self._action.set_takeoff_altitude(HEIGHT_METERS)
        self._action.arm()
        self._action.takeoff()

    def is_up(self) -> bool:
        return self._armed and self._height > HEIGHT_METERS - 1

    def land(self) -> None:
        self._action.land()

    def is_down(self) -> bool:
        return not self._armed


def fly(url: str, count: int) -> list[dict[str, Any]]:
    mavsdk = Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
    added = mavsdk.add_any_connection(url)
    assert int(added) == 0, f"{url}: {added}"
    systems = wait_for(
        "all are there",
        lambda: [s] if len(s := [x for x in mavsdk.get_systems() if x.has_autopilot()]) == count else None,
    )[0]
    vehicles = [Vehicle(system) for system in systems]
    vehicles[0].write(ITEMS)
    report: list[dict[str, Any]] = [{"system": v.system_id, **v.read()} for v in vehicles]
    for vehicle in vehicles:
        vehicle.take_off()
    for vehicle in vehicles:
        wait_for("it is up", vehicle.is_up, 60)
    for vehicle in vehicles:
        vehicle.land()
    for vehicle in vehicles:
        wait_for("it is down", vehicle.is_down, 60)
    mavsdk.destroy()
    return report


if __name__ == "__main__":
    print(json.dumps(fly(sys.argv[1], int(sys.argv[2]))))
