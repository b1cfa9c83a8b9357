"""ROS messages by their fields alone, so that no ROS is needed to test them."""

import math
from types import SimpleNamespace as Of

from roslink_bridge.frames import Pose2D
from roslink_bridge.messages import battery_of, fill_twist, map_of, map_shift_of, pose_of, scan_of
from roslink_bridge.robot import Battery, Map, Scan, Speeds


def test_odometry_message_to_pose() -> None:
    half = math.pi / 8
    pose = Of(
        position=Of(x=1.0, y=2.0, z=0.0), orientation=Of(x=0.0, y=0.0, z=math.sin(half), w=math.cos(half))
    )
    twist = Of(linear=Of(x=0.3, y=0.1, z=0.0), angular=Of(x=0.0, y=0.0, z=-0.2))
    read = pose_of(Of(pose=Of(pose=pose), twist=Of(twist=twist)))
    assert (read.x, read.y, read.forward, read.left, read.turn) == (1.0, 2.0, 0.3, 0.1, -0.2)
    assert math.isclose(read.yaw, math.pi / 4)


def test_scan_and_map_messages() -> None:
    scan = Of(angle_min=-1.0, angle_increment=0.5, range_min=0.1, range_max=3.5, ranges=(1.0, math.inf))
    assert scan_of(scan) == Scan(-1.0, 0.5, 0.1, 3.5, [1.0, math.inf])
    info = Of(width=2, height=1, resolution=0.05, origin=Of(position=Of(x=-1.0, y=-2.0)))
    assert map_of(Of(info=info, data=(0, -1))) == Map(2, 1, 0.05, -1.0, -2.0, [0, -1])
    assert scan_of(None) is None
    assert map_of(None) is None


def battery(share: float, volts: float = 0.0, amperes: float = math.nan) -> object:
    return Of(percentage=share, voltage=volts, current=amperes)


def test_unknown_battery_values() -> None:
    assert battery_of(battery(0.25)) == Battery(25)
    assert battery_of(battery(0.25, 12.5, -3.0)) == Battery(25, 12.5, 3.0)
    assert battery_of(battery(-1.0, 12.5, 0.0)) == Battery(None, 12.5, None)
    assert battery_of(battery(math.nan, math.nan)) is None
    assert battery_of(None) is None


def test_transform_message_to_map_shift() -> None:
    def transform(parent: str, child: str) -> object:
        shift = Of(translation=Of(x=1.0, y=2.0), rotation=Of(x=0.0, y=0.0, z=1.0, w=0.0))
        return Of(header=Of(frame_id=parent), child_frame_id=child, transform=shift)

    message = Of(transforms=[transform("odom", "base_link"), transform("/map", "odom")])
    assert map_shift_of(message, "odom") == Pose2D(1.0, 2.0, math.pi)
    assert map_shift_of(message, "tb3_0/odom") is None
    assert map_shift_of(Of(transforms=[]), "odom") is None


def test_speeds_to_twist_message() -> None:
    twist = Of(linear=Of(x=0.0, y=0.0, z=0.0), angular=Of(x=0.0, y=0.0, z=0.0))
    fill_twist(twist, Speeds(0.1, 0.2, 0.3, 0.4))
    assert (twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.z) == (0.1, 0.2, 0.3, 0.4)
