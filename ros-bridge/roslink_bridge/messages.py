"""Messages of ROS, which look the same in both of its versions, as the bridge has them."""

import math
from typing import Any, Optional

from .robot import Map, Pose, Scan, Speeds


def pose_of(message: Any) -> Optional[Pose]:
    if message is None:
        return None
    place, turned = message.pose.pose.position, message.pose.pose.orientation
    yaw = math.atan2(
        2 * (turned.w * turned.z + turned.x * turned.y), 1 - 2 * (turned.y * turned.y + turned.z * turned.z)
    )
    along, about = message.twist.twist.linear, message.twist.twist.angular
    return Pose(place.x, place.y, yaw, along.x, along.y, about.z)


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


def battery_of(message: Any) -> Optional[float]:
    """ROS counts it from 0 to 1, and NaN where it does not know."""
    if message is None or not math.isfinite(message.percentage):
        return None
    return float(100 * message.percentage)


def put(twist: Any, speeds: Speeds) -> None:
    twist.linear.x, twist.linear.y, twist.linear.z = speeds.forward, speeds.left, speeds.up
    twist.angular.z = speeds.turn
