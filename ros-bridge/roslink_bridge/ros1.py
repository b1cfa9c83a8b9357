"""A robot of ROS 1 (rospy), by its usual topics; it is driven by cmd_vel and sent to a simple goal."""

from typing import Any, Optional

import rospy
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import BatteryState, CompressedImage, LaserScan

try:
    from actionlib_msgs.msg import GoalID
except ImportError:  # without navigation there is nothing to cancel
    GoalID = None

from .messages import battery_of, map_of, pose_of, put, scan_of
from .robot import Map, Pose, Robot, Scan, Speeds


class Ros1Robot(Robot):
    """Callbacks come on rospy's threads; each replaces one whole value, so nothing here needs a lock."""

    def __init__(self) -> None:
        rospy.init_node("roslink_bridge", disable_signals=True)
        self._odometry: Any = None
        self._scan: Any = None
        self._image: Any = None
        self._map: Any = None
        self._battery: Any = None
        for topic, kind, keep in (
            ("odom", Odometry, self._keep_odometry),
            ("scan", LaserScan, self._keep_scan),
            ("camera/image/compressed", CompressedImage, self._keep_image),
            ("map", OccupancyGrid, self._keep_map),
            ("battery_state", BatteryState, self._keep_battery),
        ):
            rospy.Subscriber(topic, kind, keep, queue_size=1)
        self._speeds = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self._goal = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        self._cancel = rospy.Publisher("move_base/cancel", GoalID, queue_size=1) if GoalID else None

    def _keep_odometry(self, message: Any) -> None:
        self._odometry = message

    def _keep_scan(self, message: Any) -> None:
        self._scan = message

    def _keep_image(self, message: Any) -> None:
        self._image = message

    def _keep_map(self, message: Any) -> None:
        self._map = message

    def _keep_battery(self, message: Any) -> None:
        self._battery = message

    def pose(self) -> Optional[Pose]:
        return pose_of(self._odometry)

    def scan(self) -> Optional[Scan]:
        return scan_of(self._scan)

    def image(self) -> Optional[bytes]:
        return None if self._image is None else bytes(self._image.data)

    def map(self) -> Optional[Map]:
        return map_of(self._map)

    def battery(self) -> Optional[float]:
        return battery_of(self._battery)

    def drive(self, speeds: Speeds) -> None:
        twist = Twist()
        put(twist, speeds)
        self._speeds.publish(twist)

    def go_to(self, x: float, y: float) -> None:
        goal = PoseStamped()
        goal.header.stamp = rospy.Time.now()
        goal.header.frame_id = "map"
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = x, y, 1.0
        self._goal.publish(goal)

    def cancel(self) -> None:
        if self._cancel is not None:
            self._cancel.publish(GoalID())
