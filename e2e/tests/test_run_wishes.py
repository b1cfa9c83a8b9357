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
from dronemap_e2e.waiting import throughout, wait_for

FIRST_SYSTEM_ID = 201
DRONES = 2
JOINING = FIRST_SYSTEM_ID + DRONES
SPACING_METRES = 60
HEIGHT_METRES = 20
# Drones here fly on five times as far while a plan is looked for.
SEARCH_SECONDS = 0.4
NEAR_METRES = 5.0
FAR_METRES = 15.0
STANDS_METRES = 0.5
HOVER_METRES = 2.0
HOVER_SECONDS = 8
SERVO = 9
PULSE_MICROS = 1900
FENCE_METRES = 12
OUT_OF_REACH_METRES = 30_000
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
        *("--count", str(DRONES + 1), "--speedup", "5", "--sysid", str(FIRST_SYSTEM_ID)),
    )
    assert simulator.ask("sensor all Temp 21.5").startswith("ok")
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


def tasks(home: Json) -> list[Json]:
    looked = {"latitude": home["latitude"], "longitude": home["longitude"], "altitude": home["altitudeAmsl"]}
    return [
        {"type": "lookAt", **looked},
        {"type": "servo", "output": SERVO, "pulse": PULSE_MICROS},
        {"type": "photo"},
        {"type": "readSensors", "seconds": 4},
    ]


def begun(api: Api, drones: list[Json], count: int, mode: str, hover_seconds: float = 0) -> str:
    """A run whose drones are all in the air; at the first waypoint of each column they hover and do tasks."""
    places = waypoints(drones[0]["home"], count)
    for one in places[:2] if hover_seconds else []:
        one["holdSeconds"] = hover_seconds
        one["tasks"] = tasks(drones[0]["home"])
    plan = planned(api, drones, places)
    asked = api.call(
        "POST",
        "/runs",
        {"plan": plan, "mode": mode, "onCloudLoss": "continue", "searchSeconds": SEARCH_SECONDS},
    )
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


def hovered(tap: Tap, system_id: int, waypoint: Json) -> float:
    """For how many seconds of its own clock it stood there, at most at a stretch."""
    longest, since = 0.0, None
    for heard in tap.heard("GLOBAL_POSITION_INT", up=True):
        said = heard.message
        if said.get_srcSystem() == system_id:
            seconds = said.time_boot_ms / 1000
            there = distance(waypoint, [(said.lat / 1e7, said.lon / 1e7, said.alt / 1e3)]) < HOVER_METRES
            since = (since or seconds) if there else None
            longest = max(longest, seconds - since) if since is not None else longest
    return longest


def photos(tap: Tap, near: Json) -> list[int]:
    """The numbers of those that were taken there."""
    return [
        heard.message.img_idx
        for heard in tap.heard("CAMERA_FEEDBACK", up=True)
        if distance(near, [(heard.message.lat / 1e7, heard.message.lng / 1e7, heard.message.alt_msl)])
        < NEAR_METRES
    ]


def told(run: Json, trigger: str) -> list[Json]:
    return [one for one in run["explanations"] if one["trigger"] == trigger]


def by_id(run: Json) -> dict[str, Json]:
    return {one["id"]: one for one in run["waypoints"]}


def test_a_moved_waypoint_is_visited_where_it_is_now_a_cancelled_one_in_no_mission_and_tasks_are_done(
    api: Api, tap: Tap, drones: list[Json]
) -> None:
    run = begun(api, drones, 10, "automatic", HOVER_SECONDS)
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
    numbers = {drone["id"]: FIRST_SYSTEM_ID + n for n, drone in enumerate(drones)}
    for one in over["waypoints"][:2]:
        if one["id"] not in (moved["id"], cancelled["id"]):
            assert hovered(tap, numbers[one["visits"][0]["drone"]], one) >= HOVER_SECONDS - 1, one
            look, servo, photo, sensors = one["tasks"]
            assert {task["result"] for task in one["tasks"]} == {"done"}, one["tasks"]
            assert photos(tap, one) == [photo["photo"]], (photo, photos(tap, one))
            assert f"Output {SERVO} is at {PULSE_MICROS}" in servo["words"], servo
            assert "Temp 21.5" in sensors["words"], sensors
            assert look["drone"] == one["visits"][0]["drone"], look
    for trigger in ("waypointMoved", "waypointCancelled"):
        assert told(over, trigger), (trigger, [one["trigger"] for one in over["explanations"]])
    assert api.get(f"{run}/journal/replay")["same"]


def test_a_changed_plan_waits_for_an_answer_where_people_want_to_be_asked(
    api: Api, tap: Tap, drones: list[Json]
) -> None:
    run = begun(api, drones, 8, "askFirst")
    leaves, stays = (drone["id"] for drone in drones)
    heading = next(drone["next"][0] for drone in api.get(run)["drones"] if drone["id"] == leaves)
    done(api, "POST", f"{run}/drones/{leaves}/give-up")
    asked = wait_for("it asks", lambda: api.get(run)["proposal"], 60)
    assert asked["moved"] and {one["to"] for one in asked["moved"]} == {stays}, asked
    assert asked["before"]["unserved"] > asked["after"]["unserved"] == 0
    # What it was flying to it may have come to before it turned.
    orphans = {one["waypoint"] for one in asked["moved"]} - {heading}
    assert not orphans & set(next(d["next"] for d in api.get(run)["drones"] if d["id"] == stays))
    late = api.call("POST", f"{run}/answers/{asked['number'] + 7}", {"accept": True})
    assert late.status_code == 409, late.text

    done(api, "POST", f"{run}/answers/{asked['number']}", {"accept": True})
    over = wait_for("it is over", partial(ended, api, run), 240)

    result = by_id(over)
    assert {one["visits"][0]["drone"] for one in map(result.__getitem__, orphans)} == {stays}
    assert over["counts"]["visited"] == 8, over["explanations"]
    assert told(over, "answered")


def return_heights(tap: Tap, system_id: int, begin: int) -> list[float]:
    """In metres, what that vehicle was told in turn from that message on."""
    return [
        heard.message.param_value / 100
        for heard in tap.heard("PARAM_SET", up=False)[begin:]
        if heard.message.param_id == "RTL_ALT" and heard.message.target_system == system_id
    ]


def stood(track: Track) -> float:
    """How far its reports are apart, in metres."""
    here = dict(zip(("latitude", "longitude", "altitudeAmsl"), track[0], strict=True))
    return max(distance(here, [there]) for there in track)


def test_a_paused_run_stands_still_and_its_drones_fly_home_in_layers_of_their_own(
    api: Api, tap: Tap, drones: list[Json]
) -> None:
    told_before = len(tap.heard("PARAM_SET", up=False))
    run = begun(api, drones, 2, "automatic")
    done(api, "POST", f"{run}/pause")
    assert api.call("POST", f"{run}/pause").status_code == 409
    wait_for("all hold", lambda: set(stages(api.get(run)).values()) == {"holding"}, 30)

    def stand() -> bool:
        flown = tracks(tap, drones, FIRST_SYSTEM_ID)
        return all(stood(track[-8:]) < STANDS_METRES for track in flown.values())

    wait_for("they stand", stand, 20)
    visited = api.get(run)["counts"]["visited"]
    throughout("they stand", stand, 2)
    assert api.get(run)["state"] == "paused" and api.get(run)["counts"]["visited"] == visited

    done(api, "POST", f"{run}/continue")
    over = wait_for("it is over", partial(ended, api, run), 240)

    assert over["counts"]["visited"] == 2, over["explanations"]
    assert told(over, "paused") and told(over, "wentOn")
    heights = [return_heights(tap, FIRST_SYSTEM_ID + n, told_before) for n in range(DRONES)]
    layers = sorted(told_to[0] for told_to in heights)
    assert layers[0] > HEIGHT_METRES and layers[1] - layers[0] >= 5, heights
    assert {told_to[-1] for told_to in heights} == {15}, heights


def beyond(place: Json, track: Track) -> float:
    """How near a drone came to it over the ground."""
    return min(
        distance({**place, "altitudeAmsl": height}, [(north, east, height)]) for north, east, height in track
    )


def remotest(run: Json, flown: dict[str, Track]) -> Json:
    """The waypoint ahead from which all are farthest: a barrier round it surprises nobody in it."""
    ahead = [by_id(run)[one] for drone in run["drones"] for one in drone["next"]]
    return max(ahead, key=lambda one: min(beyond(one, track[-1:]) for track in flown.values()))


def test_a_new_zone_a_joining_drone_and_a_waypoint_out_of_reach(
    api: Api, tap: Tap, drones: list[Json]
) -> None:
    joining = wait_for("all is known", partial(known, api, JOINING), 120)
    # So many that the one that joins keeps some, whatever a better plan gives to others.
    run = begun(api, drones, 16, "automatic")
    done(api, "POST", f"{run}/drones", {"drone": joining["id"]})
    wait_for(
        "it has its share",
        lambda: any(drone["id"] == joining["id"] and drone["next"] for drone in api.get(run)["drones"]),
        30,
    )
    home = drones[0]["home"]
    far = done(api, "POST", f"{run}/waypoints", {"waypoints": [place(home, OUT_OF_REACH_METRES, 0)]})[
        "waypoints"
    ][-1]
    everybody = [*drones, joining]
    fenced = remotest(api.get(run), tracks(tap, everybody, FIRST_SYSTEM_ID))
    begin = len(tap.heard("GLOBAL_POSITION_INT", up=True))
    zone = {
        "type": "Feature",
        "geometry": {"type": "Point", "coordinates": [fenced["longitude"], fenced["latitude"]]},
        "properties": {"name": "Crane", "kind": "exclusion", "radius": FENCE_METRES},
    }
    kept = done(api, "POST", "/zones", zone)["id"]

    left_out = (far["id"], fenced["id"])

    def reasons() -> dict[str, str] | None:
        now = by_id(api.get(run))
        return (
            {one: now[one]["why"] for one in left_out} if all(now[one]["why"] for one in left_out) else None
        )

    before = wait_for("reasons are told while it flies", reasons, 30)
    over = wait_for("it is over", partial(ended, api, run), 240)
    assert api.call("DELETE", f"/zones/{kept}").ok

    result = by_id(over)
    for one, why in ((far["id"], "Out of range"), (fenced["id"], "Crane")):
        assert result[one]["state"] == "unserved", result[one]
        assert why in before[one] and why in result[one]["why"], (before, result[one])
    words = [one["words"] for one in over["explanations"]]
    served = [one for one in over["waypoints"] if one["id"] not in left_out]
    assert {one["state"] for one in served} == {"visited"}, words
    assert joining["id"] in {one["visits"][0]["drone"] for one in served}, "\n".join(words)
    since = tracks(tap, everybody, FIRST_SYSTEM_ID, begin)
    assert min(beyond(fenced, track) for track in since.values() if track) > FENCE_METRES
    flown = tracks(tap, everybody, FIRST_SYSTEM_ID)
    for one in served:
        assert distance(one, flown[one["visits"][0]["drone"]]) < NEAR_METRES, one
