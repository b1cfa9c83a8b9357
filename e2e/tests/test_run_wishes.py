"""What people want of a mission run while it flies, and what truly comes of it."""

import math
from collections.abc import Iterator
from functools import partial

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import EARTH_RADIUS_METERS
from dronemap_e2e.runs import Track, distance, ended, known, planned, stages, tracks
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import wait_for

FIRST_SYSTEM_ID = 201
DRONES = 2
SPACING_METRES = 60
HEIGHT_METRES = 20
NEAR_METRES = 5.0
FAR_METRES = 15.0
PER_DEGREE = math.radians(1) * EARTH_RADIUS_METERS


@pytest.fixture(scope="module")
def tap(server: Server) -> Iterator[Tap]:
    opened = Tap(server.udp_port)
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def drones(tap: Tap, api: Api, tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[Json]]:
    simulator = Simulator(
        tmp_path_factory.mktemp("wishes") / "sim.log",
        f"udp://127.0.0.1:{tap.port}",
        *("--count", str(DRONES), "--speedup", "5", "--sysid", str(FIRST_SYSTEM_ID)),
        # At this pace the usual five seconds were one: a slow machine would be a loss of the cloud.
        *("--parameter", "FS_GCS_TIMEOUT=25"),
    )
    yield [wait_for("all is known", partial(known, api, FIRST_SYSTEM_ID + n), 120) for n in range(DRONES)]
    simulator.stop()


def place(home: Json, north: float, east: float) -> Json:
    across = PER_DEGREE * math.cos(math.radians(home["latitude"]))
    return {
        "latitude": home["latitude"] + north / PER_DEGREE,
        "longitude": home["longitude"] + east / across,
        "altitude": home["altitudeAmsl"] + HEIGHT_METRES,
        "altitudeReference": "amsl",
    }


def waypoints(home: Json, count: int) -> list[Json]:
    """In two columns, north of a home."""
    return [place(home, (1 + n // 2) * SPACING_METRES, n % 2 * SPACING_METRES) for n in range(count)]


def begun(api: Api, drones: list[Json], count: int, mode: str) -> str:
    """A run whose drones are all in the air."""
    plan = planned(api, drones, waypoints(drones[0]["home"], count))
    asked = api.call("POST", "/runs", {"plan": plan, "mode": mode, "onCloudLoss": "continue"})
    assert asked.status_code == 201, asked.text
    run = f"/runs/{asked.json()['id']}"
    wait_for("all fly", lambda: set(stages(api.get(run)).values()) == {"flying"}, 120)
    return run


def done(api: Api, method: str, path: str, body: Json | None = None) -> Json:
    answer = api.call(method, path, body)
    assert answer.ok, answer.text
    said: Json = answer.json()
    return said


def mission(tap: Tap, system_id: int) -> Track:
    """The places of the mission that it was brought last."""
    places: Track = []
    for heard in tap.heard("MISSION_ITEM_INT", up=False):
        item = heard.message
        if item.target_system == system_id:
            places = [] if item.seq == 0 else places
            if item.x and item.y:
                places.append((item.x / 1e7, item.y / 1e7, item.z))
    return places


def told(run: Json, trigger: str) -> list[Json]:
    return [one for one in run["explanations"] if one["trigger"] == trigger]


def by_id(run: Json) -> dict[str, Json]:
    return {one["id"]: one for one in run["waypoints"]}


def test_a_moved_waypoint_is_visited_where_it_is_now_and_a_cancelled_one_is_in_no_mission_any_more(
    api: Api, tap: Tap, drones: list[Json]
) -> None:
    run = begun(api, drones, 10, "automatic")
    now = api.get(run)
    first, second = (drone["next"] for drone in now["drones"])
    moved, cancelled = by_id(now)[first[-1]], by_id(now)[second[-1]]
    there = {"latitude": moved["latitude"] + 45 / PER_DEGREE, "longitude": moved["longitude"]}
    done(api, "PATCH", f"{run}/waypoints/{moved['id']}", there)
    done(api, "DELETE", f"{run}/waypoints/{cancelled['id']}")

    over = wait_for("it is over", partial(ended, api, run), 240)

    flown = tracks(tap, drones, FIRST_SYSTEM_ID)
    result = by_id(over)
    assert result[cancelled["id"]]["state"] == "cancelled"
    carried = [mission(tap, FIRST_SYSTEM_ID + n) for n in range(DRONES)]
    assert all(carried), "somebody was brought no mission"
    assert min(distance(cancelled, items) for items in carried) > FAR_METRES
    assert abs(result[moved["id"]]["latitude"] - there["latitude"]) < 1e-6
    for one in over["waypoints"]:
        if one["id"] != cancelled["id"]:
            assert one["state"] == "visited", (one, [e["words"] for e in over["explanations"]])
            assert distance(one, flown[one["visits"][0]["drone"]]) < NEAR_METRES, one
    for trigger in ("waypointMoved", "waypointCancelled"):
        assert told(over, trigger), (trigger, [one["trigger"] for one in over["explanations"]])
    assert api.get(f"{run}/journal/replay")["same"]


def test_a_changed_plan_waits_for_an_answer_where_people_want_to_be_asked(
    api: Api, tap: Tap, drones: list[Json]
) -> None:
    run = begun(api, drones, 8, "askFirst")
    leaves, stays = (drone["id"] for drone in drones)
    done(api, "POST", f"{run}/drones/{leaves}/give-up")
    asked = wait_for("it asks", lambda: api.get(run)["proposal"], 60)
    assert asked["moved"] and {one["to"] for one in asked["moved"]} == {stays}, asked
    assert asked["before"]["unserved"] > asked["after"]["unserved"] == 0
    orphans = {one["waypoint"] for one in asked["moved"]}
    assert not orphans & set(next(d["next"] for d in api.get(run)["drones"] if d["id"] == stays))
    late = api.call("POST", f"{run}/answers/{asked['number'] + 7}", {"accept": True})
    assert late.status_code == 409, late.text

    done(api, "POST", f"{run}/answers/{asked['number']}", {"accept": True})
    over = wait_for("it is over", partial(ended, api, run), 240)

    result = by_id(over)
    assert {one["visits"][0]["drone"] for one in map(result.__getitem__, orphans)} == {stays}
    assert over["counts"]["visited"] == 8, over["explanations"]
    assert told(over, "answered")
