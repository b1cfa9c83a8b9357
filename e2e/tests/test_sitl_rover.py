"""A real ArduRover does at the first try what a drone of its kind is told, and never counts as flying."""

from collections.abc import Iterator

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.sitl_drone import Column, SitlDrone, go_to, look_at, place, sitl_drone, waypoint

pytestmark = [
    pytest.mark.soak,
    pytest.mark.skipif(sitl.ROVER.binary is None, reason=sitl.ROVER.why_not),
]
NEAR = place(25, 0)
FAR = place(25, 40)
REACHED_METRES = 4.0


@pytest.fixture(scope="module")
def rover(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SitlDrone]:
    with sitl_drone(tmp_path_factory.mktemp("rover"), Column("Rover", sitl.ROVER, 62)) as drone:
        yield drone


@pytest.fixture
def driving(rover: SitlDrone) -> Iterator[SitlDrone]:
    """Armed in GUIDED; with its motors off again afterwards."""
    rover.becomes_ready()
    rover.do(type="setMode", mode="GUIDED")
    rover.do(type="arm")
    yield rover
    rover.do(type="hold")
    rover.do(type="disarm")
    rover.is_down()


def test_once_it_says_that_it_is_ready_it_drives(rover: SitlDrone) -> None:
    rover.becomes_ready()
    rover.do(type="setMode", mode="GUIDED")
    rover.proved("Change the mode")
    rover.do(type="arm")
    rover.do(type="disarm")
    rover.proved("Arm, disarm")
    seen = rover.state()
    assert (seen["vehicle"], seen["kind"], seen["mode"]) == ("ArduRover", "rover", "GUIDED")
    rover.proved("Listed with its name, mode, place and battery")


def test_drive_by_commands(driving: SitlDrone) -> None:
    driving.do(**go_to(NEAR))
    driving.comes_to(NEAR, REACHED_METRES)
    driving.proved("Go to a place")
    driving.do(**go_to(FAR))
    driving.do(type="changeSpeed", metersPerSecond=1)
    driving.until("it drives as slowly as told", lambda d: 0.7 < d["motion"]["groundSpeed"] < 1.3, 30)
    driving.proved("Change speed")
    driving.do(type="hold")
    assert driving.state()["mode"] == "HOLD"
    driving.proved("Hold")
    driving.do(type="returnToLaunch")
    driving.comes_to(place(0, 0), REACHED_METRES)
    driving.proved("Return home")


def test_it_never_flies_whatever_its_height(driving: SitlDrone) -> None:
    """Its home is set five metres below it, as a drift of height makes it."""
    here = {"latitude": place(0, 0).latitude, "longitude": place(0, 0).longitude}
    driving.do(type="setHome", **here, altitude=483, altitudeReference="amsl")
    driving.until("its height has followed", lambda d: d["position"]["altitudeAboveHome"] > 3, 20)
    assert driving.state()["flight"] != "inAir"
    driving.do(type="disarm")
    driving.moves_home()
    driving.do(type="arm")


def test_what_it_cannot_is_said(rover: SitlDrone) -> None:
    rover.cannot("Take off", "rover", type="takeOff", altitude=10)
    rover.cannot("Land", "rover", type="land")
    rover.cannot("Turn on the spot", "rover", type="turn", degrees=90)
    rover.cannot("Mission: land", "item 2", type="uploadMission", items=[waypoint(NEAR), {"type": "land"}])
    climb = {"type": "takeOff", "altitude": 5}
    rover.cannot("Mission: take off", "item 1", type="uploadMission", items=[climb, waypoint(NEAR)])


def test_mission_paused_goes_on_where_it_was(rover: SitlDrone) -> None:
    way = [place(25, east) for east in (0, 25, 50)]
    items = [
        *map(waypoint, way),
        look_at(NEAR),
        {"type": "takePhoto"},
        {"type": "setServo", "output": 9, "pulse": 1500},
        {"type": "lookAhead"},
        waypoint(place(5, 50), holdSeconds=2),
    ]
    rover.becomes_ready()
    rover.upload(items)
    rover.do(type="setMode", mode="GUIDED")
    rover.do(type="arm")
    rover.do(type="startMission")
    rover.until("it has reached the first", lambda d: 0 in d["mission"]["reached"])
    rover.do(type="pauseMission")
    rover.until("it stands", lambda d: d["motion"]["groundSpeed"] < 0.2, 20)
    begun = len(rover.autopilot.ground_truth.track())
    rover.do(type="startMission")
    rover.comes_to(place(5, 50), REACHED_METRES)
    rover.until("its mission is complete", lambda d: not d["mission"]["running"], 60)
    since = rover.autopilot.ground_truth.track()[begun:]
    assert min(way[0].metres_to(*fix[:2]) for fix in since) > 2, "it did not drive to the first again"
    rover.do(type="disarm")
    for job in ("waypoint that holds", "look at a place, look ahead"):
        rover.proved(f"Mission: {job}")
    rover.proved("Mission paused and continued")
    rover.do(type="clearMission")
    rover.proved("Mission sent, read back the same, cleared")


def test_mission_that_returns(rover: SitlDrone) -> None:
    rover.becomes_ready()
    rover.upload([waypoint(NEAR), {"type": "wait", "holdSeconds": 2}, {"type": "returnToLaunch"}])
    rover.do(type="setMode", mode="GUIDED")
    rover.do(type="arm")
    begun = len(rover.autopilot.ground_truth.track())
    rover.do(type="startMission")
    rover.until("it goes home", lambda d: d["mode"] == "RTL" or not d["mission"]["running"])
    rover.comes_to(place(0, 0), REACHED_METRES)
    since = rover.autopilot.ground_truth.track()[begun:]
    assert min(NEAR.metres_to(*fix[:2]) for fix in since) < REACHED_METRES
    rover.proved("Mission: wait, photo, servo")
    rover.proved("Mission: return home")
    rover.do(type="hold")
    rover.do(type="disarm")


def test_what_is_kept_on_board(rover: SitlDrone) -> None:
    rover.keeps_on_board(("CRUISE_SPEED", 4), NEAR)
