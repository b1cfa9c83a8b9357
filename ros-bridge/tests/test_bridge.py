"""The bridge without sockets and without ROS: its messages, orders, refusals, and that it stops by itself."""

import base64
import json
import math
import zlib
from typing import Any, Dict, List

import pytest

from roslink_bridge.bridge import GET_MAP, GO_TO, HEARTBEAT, STOP, TWIST, Bridge, Identity, OutgoingMessage
from roslink_bridge.picture import png
from roslink_bridge.robot import Battery, Map, Pose, Scan, Speeds

from .stand_in import StandIn

IDENTITY = Identity(7, "rk-secret", owner="26")
STILL = Speeds()


def order(kind: int, key: object = "rk-secret", system_id: int = 7, **body: object) -> str:
    return json.dumps({"header": {"system_id": system_id, "message_id": kind, "key": key}, **body})


def twist(forward: float, turn: float = 0.0) -> str:
    return order(TWIST, vx=forward, vy=0, vz=0, wx=0, wy=0, wz=turn)


def of(published: OutgoingMessage) -> Dict[str, Any]:
    message: Dict[str, Any] = json.loads(published.text)
    assert message["header"]["message_id"] == published.kind
    return message


def published(bridge: Bridge, now: float) -> Dict[int, Dict[str, Any]]:
    return {m["header"]["message_id"]: m for m in map(of, bridge.step(now))}


@pytest.fixture
def robot() -> StandIn:
    return StandIn()


@pytest.fixture
def bridge(robot: StandIn) -> Bridge:
    return Bridge(IDENTITY, robot)


def test_sends_only_known_data(bridge: Bridge, robot: StandIn) -> None:
    assert list(published(bridge, 0)) == [0]
    robot.newest_pose = Pose(1, 2, 0.5, forward=0.3)
    robot.newest_scan = Scan(-1, 0.5, 0.1, 3.5, [1.23456, math.inf, math.nan])
    robot.newest_image = b"\xff\xd8\xff picture"
    robot.charge = Battery(83.4)
    messages = published(bridge, 1)

    assert sorted(messages) == [0, 1, 2, 4, 5]
    assert messages[2]["z"] == 0.5
    assert messages[4]["ranges"] == [1.235, None, None]
    assert base64.b64decode(messages[5]["data"]) == robot.newest_image
    assert {**messages[1], "header": None} == {"header": None, "battery_remaining": 83}
    assert messages[0]["header"]["key"] == "rk-secret"
    assert messages[0]["header"]["owner_id"] == "26"
    assert [m["header"]["sequence_number"] for m in messages.values()] == [2, 3, 4, 5, 6]


def test_message_rates(bridge: Bridge, robot: StandIn) -> None:
    robot.newest_pose = Pose(0, 0, 0)
    kinds: List[int] = []
    for turn in range(100):
        kinds += published(bridge, turn * 0.05)
    assert kinds.count(0) == 5
    assert kinds.count(2) in range(20, 26)


def test_drives_while_commanded_and_stops_after_timeout(bridge: Bridge, robot: StandIn) -> None:
    bridge.receive(twist(0.4, 9), 10)
    assert robot.driven == [Speeds(0.4, 0, 0, 1.5)], "bounded"
    bridge.step(10.4)
    bridge.receive(twist(0.4), 10.4)
    bridge.step(10.8)
    assert robot.driven[-1] != STILL
    bridge.step(10.91)
    assert robot.driven[-1] == STILL
    count = len(robot.driven)
    bridge.step(20)
    assert len(robot.driven) == count, "said once"


def test_stops_at_zero_speeds_and_at_the_end(bridge: Bridge, robot: StandIn) -> None:
    bridge.receive(twist(-0.2), 1)
    bridge.receive(twist(0), 1.1)
    assert robot.driven[-1] == STILL
    bridge.receive(twist(0.2), 2)
    bridge.stop()
    assert robot.driven[-1] == STILL
    assert robot.goals == [None]


def test_cloud_heartbeats_cause_no_action(bridge: Bridge, robot: StandIn) -> None:
    bridge.receive(twist(0.2), 1)
    assert bridge.receive(order(HEARTBEAT, type=7, name="dronemap", system_status=2, mode=0), 1.1) == []
    assert bridge.refused == 0
    assert robot.driven == [Speeds(0.2)]


def test_goal_is_cancelled_by_emergency_stop(bridge: Bridge, robot: StandIn) -> None:
    bridge.receive(order(GO_TO, x=1.5, y=-2, z=0, frame_type="false"), 1)
    bridge.receive(order(STOP), 2)
    assert robot.goals == [(1.5, -2.0), None]
    assert robot.driven[-1] == STILL
    bridge.receive(twist(0.1), 3)
    assert robot.driven[-1] == Speeds(0.1), "it listens on after a stop"


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[1]",
        "null",
        "{}",
        twist(0.4).replace("rk-secret", "another"),
        order(TWIST, system_id=8, vx=1, vy=0, vz=0, wz=0),
        order(TWIST, vx=1),
        order(TWIST, vx="fast", vy=0, vz=0, wz=0),
        order(TWIST, vx=math.nan, vy=0, vz=0, wz=0),
        order(TWIST, vx=math.inf, vy=0, vz=0, wz=0),
        order(GO_TO, x=None, y=2),
        "[" * 5000,
    ],
)
def test_foreign_and_malformed_messages_are_refused_and_counted(
    bridge: Bridge, robot: StandIn, text: str
) -> None:
    assert bridge.receive(text, 1) == []
    assert robot.driven == []
    assert robot.goals == []
    assert bridge.refused == 1


def test_map_request_is_answered_with_png(bridge: Bridge, robot: StandIn) -> None:
    assert bridge.receive(order(GET_MAP), 1) == []
    robot.newest_map = Map(3, 2, 0.05, -1, -2, [0, 100, -1, 0, 0, 0])
    (answer,) = map(of, bridge.receive(order(GET_MAP), 1))

    assert answer["header"]["message_id"] == 6
    assert (answer["width"], answer["resolution"], answer["xoffset"]) == (3, 0.05, -1)
    assert base64.b64decode(answer["data"]) == png(robot.newest_map)


def test_map_image_has_largest_y_on_top() -> None:
    picture = png(Map(3, 2, 0.05, 0, 0, [0, 100, -1, 0, 0, 0]))
    start = picture.index(b"IDAT") + 4
    length = int.from_bytes(picture[start - 8 : start - 4], "big")
    lines = zlib.decompress(picture[start : start + length])
    assert lines == bytes([0, 254, 254, 254, 0, 254, 0, 205])
