"""The bridge of a drone without sockets and without mavros."""

import math
from types import SimpleNamespace as Of
from typing import Any, Dict, List

import pytest

from roslink_bridge.bridge import GO_TO, STOP, Identity
from roslink_bridge.flying import ARM, DISARM, LAND, SET_MODE, TAKE_OFF, FlyingBridge
from roslink_bridge.mavros import SPEEDS_ONLY, fill_target, flight_of, satellites_of
from roslink_bridge.robot import Battery, Flight, Pose, Satellites, Speeds

from .stand_in import FlyingStandIn
from .test_bridge import order, published, twist

STANDBY, ACTIVE = 3, 4


@pytest.fixture
def drone() -> FlyingStandIn:
    return FlyingStandIn()


@pytest.fixture
def bridge(drone: FlyingStandIn) -> FlyingBridge:
    return FlyingBridge(Identity(7, "rk-secret", kind=3), drone)


def test_flight_state_messages(bridge: FlyingBridge, drone: FlyingStandIn) -> None:
    assert list(published(bridge, 0)) == [0]
    drone.newest_flight = Flight(ACTIVE, True, 4)
    drone.charge = Battery(80, 12.1, 3.5)
    drone.seen = Satellites(3, 47.4, 8.5, 410.5, 11)
    drone.newest_pose = Pose(1, 2, 0.5, forward=2, up=0.5, height=12.5)
    messages = published(bridge, 1)

    assert body(messages[1]) == {
        "state": 4104,
        "voltage_battery": 12.1,
        "current_battery": 3.5,
        "battery_remaining": 80,
    }
    assert body(messages[3]) == {
        "fix_type": 3,
        "lat": 47.4,
        "lon": 8.5,
        "alt": 410.5,
        "satellites_visible": 11,
    }
    assert (messages[2]["z"], messages[2]["heading"], messages[2]["vz"]) == (12.5, 0.5, 0.5)
    assert messages[0]["type"] == 3


def body(message: Dict[str, Any]) -> Dict[str, Any]:
    return {name: value for name, value in message.items() if name != "header"}


def test_unknown_flight_data_is_not_sent(bridge: FlyingBridge, drone: FlyingStandIn) -> None:
    drone.charge = Battery(None, 12.1, None)
    drone.seen = Satellites(-1)
    messages = published(bridge, 1)
    assert body(messages[1]) == {"voltage_battery": 12.1}
    assert body(messages[3]) == {"fix_type": -1}


def test_flight_orders_are_passed_on(bridge: FlyingBridge, drone: FlyingStandIn) -> None:
    for text in (
        order(SET_MODE, flightMode=4),
        order(ARM),
        order(TAKE_OFF, altitude=10),
        order(LAND),
        order(DISARM),
    ):
        assert bridge.receive(text, 1) == []
    assert drone.asked == [("mode", 4), ("arm", True), ("take off", 10.0), "land", ("arm", False)]
    assert bridge.refused == 0


@pytest.mark.parametrize(
    "text",
    [
        order(TAKE_OFF, altitude=0),
        order(TAKE_OFF, altitude=-3),
        order(TAKE_OFF, altitude=31),
        order(TAKE_OFF, altitude=math.nan),
        order(TAKE_OFF),
        order(SET_MODE, flightMode=None),
        order(SET_MODE),
        order(GO_TO, x=1, y=2),
        order(ARM, key="another"),
        order(LAND, system_id=8),
    ],
)
def test_invalid_flight_orders_are_refused(bridge: FlyingBridge, drone: FlyingStandIn, text: str) -> None:
    bridge.receive(text, 1)
    assert (drone.asked, drone.goals, drone.driven) == ([], [], [])
    assert bridge.refused == 1


def test_flies_while_commanded_and_stops_after_timeout(bridge: FlyingBridge, drone: FlyingStandIn) -> None:
    bridge.receive(twist(0.4), 10)
    bridge.step(10.4)
    assert drone.driven == [Speeds(0.4)]
    bridge.step(10.51)
    assert drone.driven[-1] == Speeds()
    bridge.receive(twist(0.4), 11)
    bridge.receive(order(STOP), 11.1)
    assert drone.driven[-1] == Speeds()


def state(**more: object) -> object:
    return Of(**{"connected": True, "armed": True, "mode": "GUIDED", "system_status": STANDBY, **more})


def test_flight_state_from_mavros() -> None:
    assert flight_of(state()) == Flight(STANDBY, True, 4)
    assert flight_of(state(mode="SMART_RTL", armed=False)) == Flight(STANDBY, False, 21)
    assert flight_of(state(mode="CMODE(77)")) == Flight(STANDBY, True, 99)
    assert flight_of(state(connected=False)) is None
    assert flight_of(None) is None


def test_altitude_above_sea_level_or_unknown() -> None:
    """That of the satellites is counted from the ellipsoid, tens of metres away."""

    def fix(status: int) -> object:
        return Of(status=Of(status=status), latitude=47.4, longitude=8.5, altitude=457.0)

    assert satellites_of(fix(0), Of(data=11), Of(amsl=410.0)) == Satellites(3, 47.4, 8.5, 410.0, 11)
    assert satellites_of(fix(2), None, None) == Satellites(4, 47.4, 8.5, None, None)
    assert satellites_of(fix(0), None, Of(amsl=math.nan)) == Satellites(3, 47.4, 8.5, None, None)
    assert satellites_of(fix(-1), Of(data=2), Of(amsl=410.0)) == Satellites(-1, visible=2)
    assert satellites_of(None, Of(data=2), None) is None


def test_speeds_are_in_body_frame() -> None:
    target: Any = Of(velocity=Of())
    fill_target(target, Speeds(1, 2, 3, 0.4))
    assert (target.velocity.x, target.velocity.y, target.velocity.z, target.yaw_rate) == (1, 2, 3, 0.4)
    assert target.coordinate_frame == 8
    ignored: List[bool] = [bool(target.type_mask >> bit & 1) for bit in range(12)]
    assert ignored == [True] * 3 + [False] * 3 + [True] * 3 + [False, True, False]
    assert target.type_mask == SPEEDS_ONLY
