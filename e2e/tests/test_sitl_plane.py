"""A real ArduPlane does at the first try what a drone of its kind is told, and comes down where it should."""

from collections.abc import Iterator

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.sitl_drone import Column, SitlDrone, go_to, land_at, look_at, place, sitl_drone, waypoint

pytestmark = [
    pytest.mark.soak,
    pytest.mark.skipif(sitl.PLANE.binary is None, reason=sitl.PLANE.why_not),
]
FLYING_METRES = 60.0
NORTH = place(600, 0, FLYING_METRES)
EAST = place(600, 500, FLYING_METRES)
ROUND_METRES = 150.0
RUNWAY = place(0, 0)
RUNWAY_METRES = 150.0
# It returns to the nearest of these and of home.
RALLY_POINT = place(0, 50, FLYING_METRES)


@pytest.fixture(scope="module")
def plane(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SitlDrone]:
    with sitl_drone(tmp_path_factory.mktemp("plane"), Column("Plane", sitl.PLANE, 63)) as drone:
        yield drone


def test_once_it_says_that_it_is_ready_it_arms(plane: SitlDrone) -> None:
    plane.becomes_ready()
    plane.do(type="arm")
    plane.do(type="disarm")
    plane.proved("Arm, disarm")
    seen = plane.state()
    assert (seen["vehicle"], seen["kind"]) == ("ArduPlane", "fixedWing")
    plane.proved("Listed with its name, mode, place and battery")


def test_what_it_cannot_says_how_it_can(plane: SitlDrone) -> None:
    for job, body in (("Take off", {"type": "takeOff", "altitude": 30}), ("Land", {"type": "land"})):
        plane.cannot(job, "mission", **body)
        plane.proved(job, "by mission")
    plane.cannot("Turn on the spot", "turn", type="turn", degrees=90)


def test_landing_nowhere_and_holds_are_refused_before_anything_is_sent(plane: SitlDrone) -> None:
    before = plane.state()["mission"]["items"]
    climb = {"type": "takeOff", "altitude": FLYING_METRES}
    sentence = plane.refused(type="uploadMission", items=[climb, waypoint(NORTH), {"type": "land"}])
    assert "latitude" in sentence or "place" in sentence, sentence
    holds = [climb, waypoint(NORTH, holdSeconds=5)]
    plane.cannot("Mission: waypoint that holds", "holdseconds", type="uploadMission", items=holds)
    assert plane.state()["mission"]["items"] == before


def test_what_is_kept_on_board(plane: SitlDrone) -> None:
    plane.keeps_on_board(("WP_RADIUS", 80), RALLY_POINT)
    plane.moves_home()


def test_mission_with_a_landing(plane: SitlDrone) -> None:
    items = [
        {"type": "takeOff", "altitude": FLYING_METRES},
        waypoint(NORTH),
        {"type": "takePhoto"},
        {"type": "setServo", "output": 9, "pulse": 1500},
        look_at(NORTH),
        waypoint(EAST),
        {"type": "lookAhead"},
        land_at(RUNWAY),
    ]
    plane.becomes_ready()
    plane.upload(items)
    plane.do(type="arm")
    plane.do(type="startMission")
    plane.truly("it climbs", lambda: plane.height() > 30, 90)
    plane.proved("Mission: take off")
    plane.do(type="pauseMission")
    plane.until("it circles", lambda d: d["mode"] == "LOITER", 30)
    plane.do(type="startMission")
    plane.truly("it has landed", lambda: not plane.autopilot.ground_truth.armed(), 400)
    assert abs(plane.height()) < 2
    assert plane.away(RUNWAY) < RUNWAY_METRES
    assert plane.nearest(NORTH) < ROUND_METRES
    assert plane.nearest(EAST) < ROUND_METRES
    plane.proved("Mission: land")
    plane.proved("Mission: look at a place, look ahead")
    plane.proved("Mission: wait, photo, servo", "photo, servo")
    plane.proved("Mission paused and continued")
    plane.do(type="clearMission")
    plane.proved("Mission sent, read back the same, cleared")


def test_it_flies_again_after_its_mission_landed_it(plane: SitlDrone) -> None:
    plane.do(type="setMode", mode="GUIDED")
    sentence = plane.refused(type="arm")
    assert "change its mode to MANUAL first" in sentence, sentence
    plane.do(type="setMode", mode="MANUAL")
    plane.becomes_ready()
    plane.do(type="arm")
    plane.do(type="disarm")


def test_flight_by_commands(plane: SitlDrone) -> None:
    plane.do(type="setMode", mode="GUIDED")
    plane.becomes_ready()
    plane.upload(
        [{"type": "takeOff", "altitude": FLYING_METRES}, waypoint(NORTH), {"type": "returnToLaunch"}]
    )
    plane.do(type="arm")
    plane.do(type="startMission")
    plane.truly("it climbs", lambda: plane.height() > 40, 90)
    plane.do(**go_to(EAST))
    plane.comes_to(EAST, ROUND_METRES)
    plane.proved("Go to a place")
    plane.do(type="changeSpeed", metersPerSecond=15)
    plane.until("it flies as slowly as told", lambda d: 13 < d["motion"]["airSpeed"] < 17, 40)
    plane.proved("Change speed")
    plane.do(type="hold")
    assert plane.state()["mode"] == "LOITER"
    plane.proved("Hold", "circles")
    plane.do(type="setMode", mode="CIRCLE")
    plane.proved("Change the mode")
    plane.do(type="startMission")
    plane.until("its mission sends it home", lambda d: d["mode"] == "RTL")
    plane.proved("Mission: return home", "circles there")
    plane.do(type="hold")
    plane.do(type="returnToLaunch")
    plane.comes_to(RUNWAY, ROUND_METRES)
    plane.proved("Return home", "circles there")
    assert plane.autopilot.ground_truth.armed()
