"""The adapter of ROS 2 with a stand-in for rclpy: its topics, their qualities, and what goes in and out."""

import math
from typing import Any, Iterator

import pytest

from roslink_bridge.robot import Battery, Flight, Flyer, Map, Pose, Robot, Satellites, Scan, Speeds

from .rclpy_stand_in import Message, Node, installed


@pytest.fixture
def node() -> Iterator[Node]:
    yield from installed()


@pytest.fixture
def robot(node: Node) -> Robot:
    from roslink_bridge.__main__ import robot

    return robot(2)


def odometry(x: float, y: float, yaw: float, forward: float) -> Any:
    message = placed(x, y, yaw)
    message.header.frame_id = "odom"
    twist = message.twist.twist
    twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.z = forward, 0.0, 0.0, 0.1
    return message


def placed(x: float, y: float, yaw: float) -> Any:
    message = Message()
    message.header.stamp.sec, message.header.stamp.nanosec = 1, 500_000_000
    pose = message.pose.pose
    pose.position.x, pose.position.y = x, y
    put_turn(pose.orientation, yaw)
    return message


def put_turn(turn: Any, yaw: float) -> None:
    turn.x = turn.y = 0.0
    turn.z, turn.w = math.sin(yaw / 2), math.cos(yaw / 2)


def test_no_data_before_first_message(robot: Robot) -> None:
    assert (robot.pose(), robot.scan(), robot.image(), robot.map(), robot.battery()) == (None,) * 5


def test_sensor_topics_and_latched_map(node: Node, robot: Robot) -> None:
    assert {topic: quality for topic, (_, quality) in node.subscriptions.items()} == {
        "odom": "best effort",
        "scan": "best effort",
        "camera/image/compressed": "best effort",
        "map": (1, "latched"),
        "battery_state": "best effort",
        "amcl_pose": (1, "latched"),
        "/tf": 10,
    }
    node.deliver("odom", odometry(1, 2, 0.5, 0.3))
    sweep = Message()
    sweep.angle_min, sweep.angle_increment, sweep.range_min, sweep.range_max = -1.0, 0.5, 0.1, 3.5
    sweep.ranges = (1.0, 2.0)
    node.deliver("scan", sweep)
    image = Message()
    image.data = bytearray(b"\xff\xd8\xff")
    node.deliver("camera/image/compressed", image)
    grid = Message()
    grid.info.width, grid.info.height, grid.info.resolution = 2, 1, 0.05
    grid.info.origin.position.x, grid.info.origin.position.y = -1.0, -2.0
    grid.data = (0, 100)
    node.deliver("map", grid)
    battery = Message()
    battery.percentage, battery.voltage, battery.current = 0.5, math.nan, math.nan
    node.deliver("battery_state", battery)

    pose = robot.pose()
    assert pose is not None
    assert pose.yaw == pytest.approx(0.5)
    assert pose == Pose(1, 2, pose.yaw, forward=0.3, turn=0.1)
    assert robot.scan() == Scan(-1, 0.5, 0.1, 3.5, [1.0, 2.0])
    assert robot.image() == b"\xff\xd8\xff"
    assert robot.map() == Map(2, 1, 0.05, -1, -2, [0, 100])
    assert robot.battery() == Battery(50)


def test_drives_and_goes_to_a_place(node: Node, robot: Robot) -> None:
    robot.drive(Speeds(0.4, 0.1, 0, -0.5))
    (twist,) = node.publishers["cmd_vel"].published
    assert (twist.linear.x, twist.linear.y, twist.angular.z) == (0.4, 0.1, -0.5)
    robot.go_to(3, 4)
    (goal,) = node.publishers["goal_pose"].published
    assert (goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w) == (3, 4, 1)
    assert (goal.header.frame_id, goal.header.stamp) == ("odom", "now"), "it knows of no map"


def test_cancel_sends_goal_at_current_pose(node: Node, robot: Robot) -> None:
    robot.cancel()
    assert node.publishers["goal_pose"].published == [], "nobody knows where that is"
    node.deliver("odom", odometry(1, 2, 0, 0))
    robot.cancel()
    (goal,) = node.publishers["goal_pose"].published
    assert (goal.pose.position.x, goal.pose.position.y) == (1, 2)


def test_goals_are_in_map_frame_once_localised(node: Node, robot: Robot) -> None:
    node.deliver("odom", odometry(1, 0, 0, 0))
    node.deliver("amcl_pose", placed(5, 6, math.pi / 2))
    node.deliver("odom", odometry(2, 0, 0, 0.3))
    pose = robot.pose()
    assert pose is not None
    assert (pose.x, pose.y, pose.yaw) == pytest.approx((5, 7, math.pi / 2))
    robot.cancel()
    (goal,) = node.publishers["goal_pose"].published
    assert (goal.pose.position.x, goal.pose.position.y) == pytest.approx((5, 7))
    assert goal.header.frame_id == "map"

    shift = Message()
    shift.header.frame_id, shift.child_frame_id = "map", "odom"
    shift.transform.translation.x, shift.transform.translation.y = 10.0, 0.0
    put_turn(shift.transform.rotation, 0)
    message = Message()
    message.transforms = [shift]
    node.deliver("/tf", message)
    pose = robot.pose()
    assert pose is not None
    assert (pose.x, pose.y) == pytest.approx((12, 0))


@pytest.fixture
def flyer(node: Node) -> Flyer:
    from roslink_bridge.__main__ import drone

    return drone(2)


def value(**fields: Any) -> Any:
    message = Message()
    for name, one in fields.items():
        setattr(message, name, one)
    return message


def test_mavros_topics_are_read(node: Node, flyer: Flyer) -> None:
    assert (flyer.pose(), flyer.flight(), flyer.satellites(), flyer.battery()) == (None,) * 4
    node.deliver("mavros/state", value(connected=True, armed=True, mode="GUIDED", system_status=4))
    node.deliver("mavros/battery", value(percentage=0.8, voltage=12.1, current=-3.5))
    node.deliver("mavros/local_position/odom", odometry(1, 2, 0.5, 0.3))
    assert flyer.pose() is None, "without a height it would pass for a robot on wheels"
    node.deliver("mavros/global_position/rel_alt", value(data=12.5))
    fix = value(latitude=47.4, longitude=8.5)
    fix.status.status = 0
    node.deliver("mavros/global_position/raw/fix", fix)
    node.deliver("mavros/global_position/raw/satellites", value(data=11))
    node.deliver("mavros/altitude", value(amsl=410.0))

    assert flyer.flight() == Flight(4, True, 4)
    assert flyer.battery() == Battery(80, 12.1, 3.5)
    assert flyer.satellites() == Satellites(3, 47.4, 8.5, 410.0, 11)
    pose = flyer.pose()
    assert pose is not None
    assert (pose.x, pose.y, pose.height) == (1, 2, 12.5)


def test_mavros_services_are_called(node: Node, flyer: Flyer) -> None:
    flyer.set_mode(4)
    flyer.set_mode(77)
    flyer.arm(True)
    flyer.take_off(10)
    flyer.land()
    flyer.arm(False)
    asked = {name: client.asked for name, client in node.clients.items()}
    assert [one.custom_mode for one in asked["mavros/set_mode"]] == ["GUIDED"]
    assert [one.value for one in asked["mavros/cmd/arming"]] == [True, False]
    assert [one.altitude for one in asked["mavros/cmd/takeoff"]] == [10.0]
    assert len(asked["mavros/cmd/land"]) == 1
    node.clients["mavros/cmd/land"].ready = False
    flyer.land()
    assert len(asked["mavros/cmd/land"]) == 1

    flyer.drive(Speeds(1, 0.5, 0.2, -0.3))
    (target,) = node.publishers["mavros/setpoint_raw/local"].published
    assert (target.velocity.x, target.velocity.z, target.yaw_rate) == (1, 0.2, -0.3)
    assert node.publishers["cmd_vel"].published == []
    flyer.cancel()
    assert node.publishers["goal_pose"].published == []
