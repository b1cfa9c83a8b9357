"""A real QuadPlane does at the first try what a drone of its kind is told."""

from collections.abc import Iterator

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.sitl_drone import Column, SitlDrone, go_to, land_at, look_at, place, sitl_drone, waypoint

pytestmark = [
    pytest.mark.soak,
    pytest.mark.skipif(sitl.QUADPLANE.binary is None, reason=sitl.QUADPLANE.why_not),
]
CLIMB_METRES = 15.0
FLYING_METRES = 40.0
NORTH = place(300, 0, FLYING_METRES)
FAR = place(1500, 0, FLYING_METRES)
ROUND_METRES = 120.0
LANDED_METRES = 15.0


@pytest.fixture(scope="module")
def quadplane(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SitlDrone]:
    with sitl_drone(tmp_path_factory.mktemp("quadplane"), Column("QuadPlane", sitl.QUADPLANE, 64)) as drone:
        yield drone


def test_flight_by_commands(quadplane: SitlDrone) -> None:
    quadplane.becomes_ready()
    seen = quadplane.state()
    assert (seen["vehicle"], seen["kind"]) == ("ArduPlane", "vtol"), seen
    quadplane.proved("Listed with its name, mode, place and battery")
    quadplane.do(type="setMode", mode="GUIDED")
    quadplane.proved("Change the mode")
    quadplane.do(type="arm")
    quadplane.proved("Arm, disarm")
    quadplane.do(type="takeOff", altitude=CLIMB_METRES)
    quadplane.climbs_to(CLIMB_METRES)
    quadplane.proved("Take off")
    quadplane.do(**go_to(NORTH))
    quadplane.comes_to(NORTH, ROUND_METRES)
    quadplane.proved("Go to a place")
    quadplane.do(**go_to(FAR))
    quadplane.do(type="changeSpeed", metersPerSecond=14)
    quadplane.until("it flies as slowly as told", lambda d: 12 < d["motion"]["airSpeed"] < 16, 40)
    quadplane.proved("Change speed")
    quadplane.do(type="hold")
    assert quadplane.state()["mode"] == "QLOITER"
    quadplane.proved("Hold")
    quadplane.do(type="returnToLaunch")
    quadplane.is_down()
    assert quadplane.away(place(0, 0)) < LANDED_METRES
    quadplane.proved("Return home")


def test_land_by_command(quadplane: SitlDrone) -> None:
    quadplane.do(type="setMode", mode="GUIDED")
    quadplane.becomes_ready()
    quadplane.do(type="arm")
    quadplane.do(type="takeOff", altitude=CLIMB_METRES)
    quadplane.climbs_to(CLIMB_METRES)
    quadplane.do(type="land")
    quadplane.is_down()
    quadplane.proved("Land")


def test_mission_with_a_landing(quadplane: SitlDrone) -> None:
    items = [
        {"type": "takeOff", "altitude": FLYING_METRES},
        look_at(NORTH),
        waypoint(NORTH),
        {"type": "takePhoto"},
        {"type": "setServo", "output": 9, "pulse": 1500},
        {"type": "lookAhead"},
        land_at(place(0, 0)),
    ]
    quadplane.do(type="setMode", mode="GUIDED")
    quadplane.becomes_ready()
    quadplane.upload(items)
    quadplane.do(type="arm")
    quadplane.do(type="startMission")
    quadplane.truly("it climbs", lambda: quadplane.height() > FLYING_METRES / 2, 120)
    quadplane.proved("Mission: take off")
    quadplane.do(type="pauseMission")
    quadplane.until("it stays", lambda d: d["mode"] == "QLOITER", 30)
    quadplane.do(type="startMission")
    quadplane.is_down()
    assert quadplane.away(place(0, 0)) < LANDED_METRES
    assert quadplane.nearest(NORTH) < ROUND_METRES
    quadplane.proved("Mission: land")
    quadplane.proved("Mission: look at a place, look ahead")
    quadplane.proved("Mission: wait, photo, servo", "photo, servo")
    quadplane.proved("Mission paused and continued")
    quadplane.do(type="clearMission")
    quadplane.proved("Mission sent, read back the same, cleared")


def test_mission_that_returns(quadplane: SitlDrone) -> None:
    quadplane.upload(
        [{"type": "takeOff", "altitude": FLYING_METRES}, waypoint(NORTH), {"type": "returnToLaunch"}]
    )
    quadplane.do(type="setMode", mode="GUIDED")
    quadplane.becomes_ready()
    quadplane.do(type="arm")
    quadplane.do(type="startMission")
    quadplane.until("its mission sends it home", lambda d: d["mode"] == "RTL")
    quadplane.proved("Mission: return home", "circles there")
    quadplane.do(type="returnToLaunch")
    quadplane.is_down()


def test_what_it_cannot_is_said(quadplane: SitlDrone) -> None:
    quadplane.cannot("Turn on the spot", "turn", type="turn", degrees=90)
    holds = [{"type": "takeOff", "altitude": FLYING_METRES}, waypoint(NORTH, holdSeconds=5)]
    quadplane.cannot("Mission: waypoint that holds", "holdseconds", type="uploadMission", items=holds)


def test_what_is_kept_on_board(quadplane: SitlDrone) -> None:
    quadplane.keeps_on_board(("WP_RADIUS", 80), NORTH)
    quadplane.moves_home()
