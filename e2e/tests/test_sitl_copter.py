"""A real ArduCopter does at the first try what a drone of its kind is told."""

from collections.abc import Iterator

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.sitl_drone import Column, SitlDrone, go_to, look_at, place, sitl_drone, waypoint

pytestmark = [
    pytest.mark.soak,
    pytest.mark.skipif(sitl.COPTER.binary is None, reason=sitl.COPTER.why_not),
]
FLYING_METRES = 12.0
NEAR = place(30, 0, FLYING_METRES)
FAR = place(60, 30, FLYING_METRES)
CIRCLE = 2  # FENCE_TYPE


@pytest.fixture(scope="module")
def copter(tmp_path_factory: pytest.TempPathFactory) -> Iterator[SitlDrone]:
    with sitl_drone(tmp_path_factory.mktemp("copter"), Column("Copter", sitl.COPTER, 61)) as drone:
        yield drone


@pytest.fixture
def flying(copter: SitlDrone) -> Iterator[SitlDrone]:
    """In the air in GUIDED; on the ground again afterwards."""
    copter.becomes_ready()
    copter.do(type="setMode", mode="GUIDED")
    copter.do(type="arm")
    copter.do(type="takeOff", altitude=FLYING_METRES)
    copter.climbs_to(FLYING_METRES)
    yield copter
    if copter.autopilot.ground_truth.armed():
        copter.do(type="land")
    copter.is_down()


def test_arming_too_early_says_what_the_vehicle_waits_for(copter: SitlDrone) -> None:
    sentence = copter.refused(type="arm")
    assert "rm: " in sentence, sentence
    assert "tilt alignment" not in sentence


def test_once_it_says_that_it_is_ready_it_flies(copter: SitlDrone) -> None:
    copter.becomes_ready()
    copter.do(type="setMode", mode="GUIDED")
    copter.proved("Change the mode")
    copter.do(type="arm")
    assert copter.autopilot.ground_truth.armed()
    copter.do(type="disarm")
    copter.proved("Arm, disarm")
    seen = copter.state()
    assert (seen["vehicle"], seen["kind"], seen["mode"]) == ("ArduCopter", "multicopter", "GUIDED")
    assert seen["battery"]["percent"] > 90
    assert place(0, 0).metres_to(seen["position"]["latitude"], seen["position"]["longitude"]) < 3
    copter.proved("Listed with its name, mode, place and battery")


def test_flight_by_commands(flying: SitlDrone) -> None:
    flying.proved("Take off")
    flying.do(**go_to(NEAR))
    flying.comes_to(NEAR, 2)
    flying.proved("Go to a place")
    flying.do(type="turn", degrees=90)
    flying.proved("Turn on the spot")
    flying.do(**go_to(FAR))
    flying.do(type="hold")
    assert flying.state()["mode"] == "BRAKE"
    flying.proved("Hold")
    flying.do(type="returnToLaunch")
    flying.is_down()
    assert flying.away(place(0, 0)) < 3
    flying.proved("Return home")


def test_speed_is_changed(flying: SitlDrone) -> None:
    flying.do(**go_to(place(200, 0, FLYING_METRES)))
    flying.do(type="changeSpeed", metersPerSecond=3)
    flying.until("it flies as slowly as told", lambda d: 2.5 < d["motion"]["groundSpeed"] < 3.5, 30)
    flying.do(type="changeSpeed", metersPerSecond=8)
    flying.until("it flies as fast as told", lambda d: 7.5 < d["motion"]["groundSpeed"] < 8.5, 30)
    flying.proved("Change speed")


def test_mission_with_every_task(copter: SitlDrone) -> None:
    items = [
        {"type": "takeOff", "altitude": FLYING_METRES},
        look_at(NEAR),
        waypoint(NEAR, holdSeconds=3),
        {"type": "takePhoto"},
        {"type": "setServo", "output": 9, "pulse": 1500},
        {"type": "wait", "holdSeconds": 2},
        {"type": "lookAhead"},
        {**waypoint(FAR), "altitude": 500, "altitudeReference": "amsl"},
        {"type": "returnToLaunch"},
    ]
    copter.becomes_ready()
    copter.upload(items)
    kept = [item["type"] for item in copter.state()["mission"]["items"]]
    assert kept == [item["type"] for item in items]
    copter.do(type="setMode", mode="GUIDED")
    copter.do(type="arm")
    copter.do(type="startMission")
    copter.truly("it is armed", copter.autopilot.ground_truth.armed, 10)
    copter.is_down()
    assert copter.nearest(NEAR) < 2
    assert copter.nearest(FAR) < 3
    for job in ("take off", "waypoint that holds", "wait, photo, servo", "look at a place, look ahead"):
        copter.proved(f"Mission: {job}")
    copter.proved("Mission: return home")
    copter.do(type="clearMission")
    copter.proved("Mission sent, read back the same, cleared")


def test_after_a_mission_that_returned_it_can_be_flown_again(copter: SitlDrone) -> None:
    """The mission before has left it in RTL, in which no Copter arms."""
    copter.upload([{"type": "takeOff", "altitude": 5}, {"type": "returnToLaunch"}])
    copter.becomes_ready()
    copter.do(type="setMode", mode="GUIDED")
    copter.do(type="arm")
    copter.do(type="startMission")
    copter.truly("it flies", lambda: copter.height() > 3, 60)
    copter.is_down()
    sentence = copter.refused(type="arm")
    assert "change its mode to GUIDED" in sentence, sentence
    copter.do(type="setMode", mode="GUIDED")
    copter.do(type="arm")
    copter.do(type="disarm")


def test_mission_paused_goes_on_where_it_was(copter: SitlDrone) -> None:
    way = [place(30, east, FLYING_METRES) for east in (0, 30, 60, 90)]
    copter.upload([{"type": "takeOff", "altitude": FLYING_METRES}, *map(waypoint, way), {"type": "land"}])
    copter.do(type="setMode", mode="GUIDED")
    copter.do(type="arm")
    copter.do(type="startMission")
    copter.until("it has reached the second", lambda d: 2 in d["mission"]["reached"])
    copter.do(type="pauseMission")
    copter.until("it stands", lambda d: d["motion"]["groundSpeed"] < 0.5, 20)
    begun = len(copter.autopilot.ground_truth.track())
    copter.do(type="startMission")
    copter.is_down()
    since = copter.autopilot.ground_truth.track()[begun:]
    assert min(way[0].metres_to(*fix[:2]) for fix in since) > 20, "it did not fly the first again"
    assert copter.away(way[3]) < 3
    copter.proved("Mission paused and continued")
    copter.proved("Mission: land")


def test_hold_of_half_seconds_is_refused_before_anything_is_sent(copter: SitlDrone) -> None:
    before = copter.state()["mission"]
    sentence = copter.refused(type="uploadMission", items=[waypoint(NEAR, holdSeconds=2.5)])
    assert "holdSeconds" in sentence, sentence
    assert copter.state()["mission"] == before


def test_land_by_command(flying: SitlDrone) -> None:
    flying.do(type="land")
    flying.is_down()
    flying.proved("Land")


def test_its_own_fence_is_named_where_it_forbids_a_place(flying: SitlDrone) -> None:
    flying.keep("parameters/FENCE_TYPE", {"value": CIRCLE})
    flying.keep("parameters/FENCE_RADIUS", {"value": 60})
    flying.keep("parameters/FENCE_ENABLE", {"value": 1})
    sentence = flying.refused(**go_to(place(150, 0, FLYING_METRES)))
    flying.keep("parameters/FENCE_ENABLE", {"value": 0})
    assert "FENCE_RADIUS 60 m" in sentence, sentence
    assert flying.away(place(0, 0)) < 5


def test_without_a_position_it_says_what_is_left(flying: SitlDrone) -> None:
    flying.keep("parameters/SIM_GPS_DISABLE", {"value": 1})
    flying.until("its fail-safe lands it", lambda d: d["mode"] == "LAND", 60)
    sentence = flying.refused(type="hold")
    assert "it can land" in sentence and "ALT_HOLD" in sentence, sentence
    flying.do(type="setMode", mode="ALT_HOLD")
    flying.do(type="land")
    flying.is_down()
    flying.keep("parameters/SIM_GPS_DISABLE", {"value": 0})


def test_what_is_kept_on_board(copter: SitlDrone) -> None:
    copter.keeps_on_board(("RTL_ALT", 2000), NEAR)
    copter.moves_home()
