"""Poses on the map by odometry and localisation."""

import math

import pytest

from roslink_bridge.frames import Localiser, Pose2D
from roslink_bridge.robot import Pose

QUARTER = math.pi / 2


def at(pose: Pose) -> "list[float]":
    return [pose.x, pose.y, pose.yaw]


def where(localiser: Localiser) -> "list[float]":
    pose = localiser.pose()
    assert pose is not None
    return at(pose)


def test_pose_without_localisation_is_odometry() -> None:
    localiser = Localiser()
    localiser.map_pose(Pose2D(5, 5, 0), 1)
    assert localiser.pose() is None
    localiser.odometry(Pose(1, 2, 0.5, forward=0.3), 1)
    assert localiser.pose() == Pose(1, 2, 0.5, forward=0.3)
    assert not localiser.localised


def test_odometry_since_localisation_is_added_on_map() -> None:
    localiser = Localiser()
    for second in range(10):
        localiser.odometry(Pose(second, 0, 0, forward=1), second)
    # Seven seconds ago, seven metres back, it stood at (3, 4), looking along y.
    localiser.map_pose(Pose2D(3, 4, QUARTER), 2.1)

    assert where(localiser) == pytest.approx([3, 11, QUARTER])
    localiser.odometry(Pose(10, 1, QUARTER, forward=1), 10)
    assert where(localiser) == pytest.approx([2, 12, math.pi])
    pose = localiser.pose()
    assert pose is not None
    assert pose.forward == 1, "speeds are its own"


def test_transform_takes_precedence_over_pose() -> None:
    localiser = Localiser()
    localiser.odometry(Pose(1, 0, 0), 1)
    localiser.transform(Pose2D(10, 20, math.pi))
    localiser.map_pose(Pose2D(0, 0, 0), 1)
    assert where(localiser) == pytest.approx([9, 20, math.pi])


def test_inverse_undoes_shift() -> None:
    shift = Pose2D(1.5, -2, 2.5)
    back = shift.of(shift.inverse())
    assert [back.x, back.y, back.yaw] == pytest.approx([0, 0, 0])
