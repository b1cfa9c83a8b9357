"""Messages of ROS, which look the same in both of its versions, as the bridge has them."""

import math
from typing import Any, Optional

from .frames import Turned
from .robot import Battery, Map, Pose, Scan, Speeds


def turned_of(place: Any, turned: Any) -> Turned:
    """Of a position or translation, and a quaternion."""
    yaw = math.atan2(
        2 * (turned.w * turned.z + turned.x * turned.y), 1 - 2 * (turned.y * turned.y + turned.z * turned.z)
    )
    return Turned(place.x, place.y, yaw)


def placed_of(message: Any) -> Turned:
    """Of what says a pose with its uncertainty: an odometry, or AMCL."""
    return turned_of(message.pose.pose.position, message.pose.pose.orientation)


def pose_of(message: Any) -> Pose:
    there = placed_of(message)
    along, about = message.twist.twist.linear, message.twist.twist.angular
    return Pose(there.x, there.y, there.yaw, along.x, along.y, about.z, up=along.z)


def map_shift_of(message: Any, odometry_frame: str) -> Optional[Turned]:
    """How the frame of the odometry lies in that of the map, where a message of tf says so."""
    for one in message.transforms:
        names = (one.header.frame_id.lstrip("/"), one.child_frame_id.lstrip("/"))
        if names == ("map", odometry_frame.lstrip("/")):
            return turned_of(one.transform.translation, one.transform.rotation)
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


def put(twist: Any, speeds: Speeds) -> None:
    twist.linear.x, twist.linear.y, twist.linear.z = speeds.forward, speeds.left, speeds.up
    twist.angular.z = speeds.turn
