"""A robot of ROS 1 (rospy), by its usual topics; it is driven by cmd_vel and sent to a simple goal."""

from typing import Any

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import BatteryState, CompressedImage, LaserScan

try:
    from actionlib_msgs.msg import GoalID
except ImportError:  # without navigation there is nothing to cancel
    GoalID = None
try:
    from tf2_msgs.msg import TFMessage
except ImportError:  # then what localises it has to say so itself
    TFMessage = None

from .messages import fill_twist
from .robot import Speeds
from .topic_robot import IMAGE, MAP, SCAN, TopicRobot


class Ros1Robot(TopicRobot):
    """Messages come on rospy's threads."""

    def __init__(self) -> None:
        super().__init__()
        rospy.init_node("roslink_bridge", disable_signals=True)
        for topic, kind in ((SCAN, LaserScan), (IMAGE, CompressedImage), (MAP, OccupancyGrid)):
            self._subscribe(topic, kind)
        self._subscribe(self.BATTERY, BatteryState)
        rospy.Subscriber(self.ODOMETRY, Odometry, self._on_odometry, queue_size=1)
        rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self._on_pose, queue_size=1)
        if TFMessage is not None:
            rospy.Subscriber("/tf", TFMessage, self._on_transform, queue_size=10)
        self._speeds = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self._goal = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        self._cancel = rospy.Publisher("move_base/cancel", GoalID, queue_size=1) if GoalID else None

    def _subscribe(self, topic: str, kind: Any) -> None:
        rospy.Subscriber(topic, kind, self._newest_callback(topic), queue_size=1)

    def _seconds_of(self, message: Any) -> float:
        return float(message.header.stamp.to_sec())

    def drive(self, speeds: Speeds) -> None:
        twist = Twist()
        fill_twist(twist, speeds)
        self._speeds.publish(twist)

    def go_to(self, x: float, y: float) -> None:
        goal = self._goal_pose(PoseStamped(), x, y)
        goal.header.stamp = rospy.Time.now()
        self._goal.publish(goal)

    def cancel(self) -> None:
        if self._cancel is not None:
            self._cancel.publish(GoalID())
