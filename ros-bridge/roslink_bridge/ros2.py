"""A robot of ROS 2 (rclpy), by its usual topics; it is driven by cmd_vel and sent to a goal pose."""

import threading
from typing import Any

import rclpy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import BatteryState, CompressedImage, LaserScan
from tf2_msgs.msg import TFMessage

from .messages import fill_twist
from .robot import Speeds
from .topic_robot import IMAGE, MAP, SCAN, TopicRobot


class Ros2Robot(TopicRobot):
    """Messages come on a thread of its own."""

    def __init__(self) -> None:
        super().__init__()
        rclpy.init()
        self._node = rclpy.create_node("roslink_bridge")
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        for topic, kind, quality in (
            (SCAN, LaserScan, qos_profile_sensor_data),
            (IMAGE, CompressedImage, qos_profile_sensor_data),
            (MAP, OccupancyGrid, latched),
            (self.BATTERY, BatteryState, qos_profile_sensor_data),
        ):
            self._node.create_subscription(kind, topic, self._newest_callback(topic), quality)
        subscribe = self._node.create_subscription
        subscribe(Odometry, self.ODOMETRY, self._on_odometry, qos_profile_sensor_data)
        subscribe(PoseWithCovarianceStamped, "amcl_pose", self._on_pose, latched)
        subscribe(TFMessage, "/tf", self._on_transform, 10)
        self._speeds = self._node.create_publisher(Twist, "cmd_vel", 1)
        self._goal = self._node.create_publisher(PoseStamped, "goal_pose", 1)
        self._begin()

    def _begin(self) -> None:
        """No message is received before all of it is made."""
        threading.Thread(target=rclpy.spin, args=(self._node,), name="rclpy", daemon=True).start()

    def _seconds_of(self, message: Any) -> float:
        stamp = message.header.stamp
        return float(stamp.sec + stamp.nanosec / 1e9)

    def _now(self) -> Any:
        return self._node.get_clock().now().to_msg()

    def drive(self, speeds: Speeds) -> None:
        twist = Twist()
        fill_twist(twist, speeds)
        self._speeds.publish(twist)

    def go_to(self, x: float, y: float) -> None:
        self._goal.publish(self._pose(x, y))

    def cancel(self) -> None:
        """Navigation takes a newer goal in the place of an older one: where the robot is."""
        pose = self.pose()
        if pose is not None:
            self._goal.publish(self._pose(pose.x, pose.y))

    def _pose(self, x: float, y: float) -> Any:
        goal = self._goal_pose(PoseStamped(), x, y)
        goal.header.stamp = self._now()
        return goal
