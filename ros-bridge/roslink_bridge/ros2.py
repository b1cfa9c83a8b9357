"""A robot of ROS 2 (rclpy), by its usual topics; it is driven by cmd_vel and sent to a goal pose."""

import threading
from typing import Any, Dict, Optional

import rclpy
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import BatteryState, CompressedImage, LaserScan

from .messages import battery_of, map_of, pose_of, put, scan_of
from .robot import Map, Pose, Robot, Scan, Speeds


class Ros2Robot(Robot):
    """Callbacks come on a thread of its own; each replaces one whole value, so nothing needs a lock."""

    def __init__(self) -> None:
        rclpy.init()
        self._node = rclpy.create_node("roslink_bridge")
        self._newest: Dict[str, Any] = {}
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for topic, kind, quality in (
            ("odom", Odometry, qos_profile_sensor_data),
            ("scan", LaserScan, qos_profile_sensor_data),
            ("camera/image/compressed", CompressedImage, qos_profile_sensor_data),
            ("map", OccupancyGrid, latched),
            ("battery_state", BatteryState, qos_profile_sensor_data),
        ):
            self._node.create_subscription(kind, topic, self._keeper(topic), quality)
        self._speeds = self._node.create_publisher(Twist, "cmd_vel", 1)
        self._goal = self._node.create_publisher(PoseStamped, "goal_pose", 1)
        threading.Thread(target=rclpy.spin, args=(self._node,), name="rclpy", daemon=True).start()

    def _keeper(self, topic: str) -> Any:
        def keep(message: Any) -> None:
            self._newest[topic] = message

        return keep

    def pose(self) -> Optional[Pose]:
        return pose_of(self._newest.get("odom"))

    def scan(self) -> Optional[Scan]:
        return scan_of(self._newest.get("scan"))

    def image(self) -> Optional[bytes]:
        image = self._newest.get("camera/image/compressed")
        return None if image is None else bytes(image.data)

    def map(self) -> Optional[Map]:
        return map_of(self._newest.get("map"))

    def battery(self) -> Optional[float]:
        return battery_of(self._newest.get("battery_state"))

    def drive(self, speeds: Speeds) -> None:
        twist = Twist()
        put(twist, speeds)
        self._speeds.publish(twist)

    def go_to(self, x: float, y: float) -> None:
        self._goal.publish(self._pose(x, y))

    def cancel(self) -> None:
        """Navigation takes a newer goal in the place of an older one: where the robot is."""
        pose = self.pose()
        if pose is not None:
            self._goal.publish(self._pose(pose.x, pose.y))

    def _pose(self, x: float, y: float) -> Any:
        goal = PoseStamped()
        goal.header.stamp = self._node.get_clock().now().to_msg()
        goal.header.frame_id = "map"
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = float(x), float(y), 1.0
        return goal
