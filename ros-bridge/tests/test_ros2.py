"""The adapter of ROS 2 with a stand-in for rclpy: its topics, their qualities, and what goes in and out."""

import math
from typing import Any, Iterator

import pytest

from roslink_bridge.robot import Map, Pose, Robot, Scan, Speeds

from .rclpy_stand_in import Message, Node, installed


@pytest.fixture
def node() -> Iterator[Node]:
    yield from installed()


@pytest.fixture
def robot(node: Node) -> Robot:
    from roslink_bridge.__main__ import robot

    return robot(2)


def odometry(x: float, y: float, yaw: float, forward: float) -> Any:
    message = Message()
    pose, twist = message.pose.pose, message.twist.twist
    pose.position.x, pose.position.y = x, y
    pose.orientation.x = pose.orientation.y = 0.0
    pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    twist.linear.x, twist.linear.y, twist.angular.z = forward, 0.0, 0.1
    return message


def test_knows_nothing_before_it_has_heard(robot: Robot) -> None:
    assert (robot.pose(), robot.scan(), robot.image(), robot.map(), robot.battery()) == (None,) * 5


def test_hears_sensors_as_they_come_and_maps_that_were_said_before(node: Node, robot: Robot) -> None:
    assert {topic: quality for topic, (_, quality) in node.heard.items()} == {
        "odom": "best effort",
        "scan": "best effort",
        "camera/image/compressed": "best effort",
        "map": (1, "latched"),
        "battery_state": "best effort",
    }
    node.hears("odom", odometry(1, 2, 0.5, 0.3))
    sweep = Message()
    sweep.angle_min, sweep.angle_increment, sweep.range_min, sweep.range_max = -1.0, 0.5, 0.1, 3.5
    sweep.ranges = (1.0, 2.0)
    node.hears("scan", sweep)
    image = Message()
    image.data = bytearray(b"\xff\xd8\xff")
    node.hears("camera/image/compressed", image)
    grid = Message()
    grid.info.width, grid.info.height, grid.info.resolution = 2, 1, 0.05
    grid.info.origin.position.x, grid.info.origin.position.y = -1.0, -2.0
    grid.data = (0, 100)
    node.hears("map", grid)
    battery = Message()
    battery.percentage = 0.5
    node.hears("battery_state", battery)

    pose = robot.pose()
    assert pose is not None
    assert pose.yaw == pytest.approx(0.5)
    assert pose == Pose(1, 2, pose.yaw, forward=0.3, turn=0.1)
    assert robot.scan() == Scan(-1, 0.5, 0.1, 3.5, [1.0, 2.0])
    assert robot.image() == b"\xff\xd8\xff"
    assert robot.map() == Map(2, 1, 0.05, -1, -2, [0, 100])
    assert robot.battery() == 50


def test_drives_and_goes_to_a_place(node: Node, robot: Robot) -> None:
    robot.drive(Speeds(0.4, 0.1, 0, -0.5))
    (twist,) = node.publishers["cmd_vel"].said
    assert (twist.linear.x, twist.linear.y, twist.angular.z) == (0.4, 0.1, -0.5)
    robot.go_to(3, 4)
    (goal,) = node.publishers["goal_pose"].said
    assert (goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w) == (3, 4, 1)
    assert (goal.header.frame_id, goal.header.stamp) == ("map", "now")


def test_gives_a_way_up_by_going_where_it_is(node: Node, robot: Robot) -> None:
    robot.cancel()
    assert node.publishers["goal_pose"].said == [], "nobody knows where that is"
    node.hears("odom", odometry(1, 2, 0, 0))
    robot.cancel()
    (goal,) = node.publishers["goal_pose"].said
    assert (goal.pose.position.x, goal.pose.position.y) == (1, 2)
