"""Mission runs of real autopilots: none is lost because it was not ready yet, or because of one waypoint."""

from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point
from dronemap_e2e.runs import run_if_over
from dronemap_e2e.sitl_drone import HOME, Column, SitlDrone, place, sitl_drones
from dronemap_e2e.waiting import wait_for

pytestmark = pytest.mark.soak
HEIGHT_METRES = 20.0
RUN_SECONDS = 420
PASSED_METRES = 4.0
KINDS = [
    Column("Copter", sitl.COPTER, 71),
    Column("Rover", sitl.ROVER, 72),
    Column("Plane", sitl.PLANE, 73),
]
MISSING = [kind.firmware.why_not for kind in KINDS if kind.firmware.binary is None]


def as_waypoint(point: Point, **more: object) -> Json:
    where = {"latitude": point.latitude, "longitude": point.longitude, "altitude": point.altitude}
    return {**where, **more}


def look_at(point: Point) -> Json:
    return {"type": "lookAt", "latitude": point.latitude, "longitude": point.longitude, "altitude": 0}


def planned(api: Api, drones: list[SitlDrone], waypoints: list[Json]) -> str:
    """A plan, as soon as all is known of them that it takes."""
    body = {
        "drones": [drone.id for drone in drones],
        "waypoints": waypoints,
        "seconds": 1,
        "objective": {"kind": "earliestEnd", "everyDrone": True},
    }

    said: list[str] = []

    def ask() -> str | None:
        answer = api.call("POST", "/plans", body)
        said[:] = [answer.text]
        return str(answer.json()["id"]) if answer.status_code == 202 else None

    try:
        plan = wait_for("a plan is taken", ask, 120, every=1)
    except AssertionError as error:
        raise AssertionError(f"{error}: {said}") from None
    done = wait_for("the plan is finished", lambda: _finished(api.get(f"/plans/{plan}")), 60)
    assert not done["result"]["unserved"], done
    return plan


def _finished(plan: Json) -> Json | None:
    return plan if plan["state"] == "finished" else None


def flown(api: Api, plan: str) -> Json:
    """The run of a plan once it is over."""
    started = api.call("POST", "/runs", {"plan": plan})
    assert started.status_code == 201, started.text
    run = f"/runs/{started.json()['id']}"
    return wait_for("it is over", partial(run_if_over, api, run), RUN_SECONDS, every=1)


@pytest.mark.skipif(sitl.COPTER.binary is None, reason=sitl.COPTER.why_not)
def test_four_copters_that_have_just_been_switched_on(tmp_path: Path) -> None:
    columns = [Column("Copter", sitl.COPTER, 81 + number) for number in range(4)]
    points = [place(40 + 25 * (n // 4), 25 * (n % 4), HEIGHT_METRES) for n in range(8)]
    with sitl_drones(tmp_path, columns, apart_metres=20) as drones:
        waypoints = [as_waypoint(point, tasks=[look_at(place(60, 40))]) for point in points]
        over = flown(drones[0].api, planned(drones[0].api, drones, waypoints))
        words = [one["words"] for one in over["explanations"]]
        assert over["counts"]["visited"] == len(points), words
        assert not any(one["stage"] in ("left", "suspended", "lost") for one in over["drones"]), words
        for point in points:
            assert min(drone.nearest(point) for drone in drones) < PASSED_METRES, words
        for drone in drones:
            drone.is_down()
        drones[0].proved("Mission run with other vehicles")


@pytest.mark.skipif(bool(MISSING), reason=", ".join(MISSING))
def test_copter_rover_and_plane_in_one_run(tmp_path: Path) -> None:
    # A rover's home may lie hundreds of metres beside its real height until it was driven.
    points = [place(150 + 60 * n, 40 * n, HOME[2] + 60.0) for n in range(3)]
    with sitl_drones(tmp_path, KINDS, apart_metres=25) as drones:
        api = drones[0].api
        over = flown(
            api, planned(api, drones, [as_waypoint(point, altitudeReference="amsl") for point in points])
        )
        words = [one["words"] for one in over["explanations"]]
        assert over["counts"]["visited"] == len(points), words
        for drone in drones:
            drone.proved("Mission run with other vehicles")
