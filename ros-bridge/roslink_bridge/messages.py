"""Messages of ROS, which look the same in both of its versions, as the bridge has them."""

import math
from typing import Any, Optional

from .frames import Pose2D
from .robot import Battery, Map, Pose, Scan, Speeds


def pose2d_of(place: Any, pose: Any) -> Pose2D:
    """Pose of a position or translation, and a quaternion."""
    yaw = math.atan2(2 * (pose.w * pose.z + pose.x * pose.y), 1 - 2 * (pose.y * pose.y + pose.z * pose.z))
    return Pose2D(place.x, place.y, yaw)


def map_pose_of(message: Any) -> Pose2D:
    """Pose of a message with uncertainty: an odometry, or AMCL's."""
    return pose2d_of(message.pose.pose.position, message.pose.pose.orientation)


def pose_of(message: Any) -> Pose:
    there = map_pose_of(message)
    along, about = message.twist.twist.linear, message.twist.twist.angular
    return Pose(there.x, there.y, there.yaw, along.x, along.y, about.z, up=along.z)


def map_shift_of(message: Any, odometry_frame: str) -> Optional[Pose2D]:
    """Transform from the odometry's frame to the map's, if a message of tf has it."""
    for one in message.transforms:
        names = (one.header.frame_id.lstrip("/"), one.child_frame_id.lstrip("/"))
        if names == ("map", odometry_frame.lstrip("/")):
            return pose2d_of(one.transform.translation, one.transform.rotation)
    return None


def scan_of(message: Any) -> Optional[Scan]:
    if message is None:
        return None
    return Scan(
        message.angle_min, message.angle_increment, message.range_min, message.range_max, list(message.ranges)
    )


def map_of(message: Any) -> Optional[Map]:
    if message is None:
        return None
    info = message.info
    corner = info.origin.position
    return Map(info.width, info.height, info.resolution, corner.x, corner.y, list(message.data))


def battery_of(message: Any) -> Optional[Battery]:
    """ROS counts it from 0 to 1, NaN where it does not know, and what it takes out as less than nothing."""
    if message is None:
        return None
    known = math.isfinite(message.percentage) and 0 <= message.percentage <= 1
    volts = message.voltage if math.isfinite(message.voltage) and message.voltage > 0 else None
    amperes = -message.current if math.isfinite(message.current) and message.current < 0 else None
    if not known and volts is None:
        return None
    return Battery(100 * message.percentage if known else None, volts, amperes)


def fill_twist(twist: Any, speeds: Speeds) -> None:
    twist.linear.x, twist.linear.y, twist.linear.z = speeds.forward, speeds.left, speeds.up
    twist.angular.z = speeds.turn
