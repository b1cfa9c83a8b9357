"""A mission of several drones, planned and flown by three calls."""

import math
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import EARTH_RADIUS_METERS, Point
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import wait_for

FIRST_SYSTEM_ID = 171
DRONES = 3
WAYPOINTS = 12
SPACING_METRES = 45
HEIGHT_METRES = 25
NEAR_METRES = 3
NEAR_HEIGHT_METRES = 2


@pytest.fixture
def simulator(tap: Tap, tmp_path: Path) -> Iterator[Simulator]:
    started = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{tap.port}",
        *("--count", str(DRONES), "--speedup", "5", "--sysid", str(FIRST_SYSTEM_ID)),
    )
    yield started
    started.stop()


def known(api: Api, system_id: int) -> Json | None:
    """The drone, once all is known of it that a plan takes."""
    drone = api.ready(system_id)
    complete = drone and drone["battery"] and drone["link"]["quality"]["lossShort"] is not None
    return drone if complete else None


def places(home: Json) -> list[Point]:
    """Four by three, west of a home, so far above it; altitudes above the sea."""
    per_degree = math.radians(1) * EARTH_RADIUS_METERS
    east = per_degree * math.cos(math.radians(home["latitude"]))
    return [
        Point(
            home["latitude"] + (n % 4 - 1) * SPACING_METRES / per_degree,
            home["longitude"] - (1 + n // 4) * SPACING_METRES / east,
            home["altitudeAmsl"] + HEIGHT_METRES,
        )
        for n in range(WAYPOINTS)
    ]


def plan(api: Api, path: str, state: str) -> Json | None:
    now = api.get(path)
    return now if now["state"] == state else None


def passed_by(tap: Tap, point: Point) -> set[int]:
    """The vehicles that said of themselves that they were there."""
    return {
        heard.message.get_srcSystem()
        for heard in tap.heard("GLOBAL_POSITION_INT", up=True)
        if abs(heard.message.alt / 1000 - point.altitude) < NEAR_HEIGHT_METRES
        and point.metres_to(heard.message.lat / 1e7, heard.message.lon / 1e7) < NEAR_METRES
    }


def test_three_drones_fly_twelve_waypoints_by_three_calls(api: Api, tap: Tap, simulator: Simulator) -> None:
    drones = [wait_for("all is known", partial(known, api, FIRST_SYSTEM_ID + n), 120) for n in range(DRONES)]
    points = places(drones[0]["home"])
    asked = api.call(
        "POST",
        "/plans",
        {
            "drones": [drone["id"] for drone in drones],
            "waypoints": [
                {
                    "id": f"w{n}",
                    "latitude": point.latitude,
                    "longitude": point.longitude,
                    "altitude": point.altitude,
                    "altitudeReference": "amsl",
                }
                for n, point in enumerate(points)
            ],
            "seconds": 1,
        },
    )
    assert asked.status_code == 202, asked.text
    path = f"/plans/{asked.json()['id']}"
    finished = wait_for("the plan is finished", partial(plan, api, path, "finished"), 60)
    result = finished["result"]
    assert result["faults"] == [] and result["unserved"] == [], result
    visits = [stop["waypoint"] for tour in result["tours"] for stop in tour["stops"]]
    assert sorted(visits) == sorted(f"w{n}" for n in range(WAYPOINTS))
    assert len(result["tours"]) == DRONES

    accepted = api.call("POST", f"{path}/accept", {"start": True})
    assert accepted.status_code in (200, 202), accepted.text

    wait_for("all have started", lambda: _stages(api, path) == {"started"}, 120)
    # Who was to go there goes there; on its way it may come by where others were.
    for n, drone in enumerate(drones):
        for number in _waypoints(result, drone["id"]):
            own = FIRST_SYSTEM_ID + n
            wait_for(f"{own} is at waypoint {number}", partial(_came_by, tap, own, points[number]), 180)


def _came_by(tap: Tap, system_id: int, point: Point) -> bool:
    return system_id in passed_by(tap, point)


def _waypoints(result: Json, drone: str) -> list[int]:
    return [
        int(stop["waypoint"].removeprefix("w"))
        for tour in result["tours"]
        if tour["drone"] == drone
        for stop in tour["stops"]
    ]


def _stages(api: Api, path: str) -> set[str]:
    launch = api.get(path)["launch"]
    stages = {drone["stage"] for drone in launch["drones"]}
    assert "failed" not in stages, launch
    return stages
