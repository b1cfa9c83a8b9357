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

from .heard import IMAGE, MAP, SCAN, HeardRobot
from .messages import put
from .robot import Speeds


class Ros1Robot(HeardRobot):
    """Messages come on rospy's threads."""

    def __init__(self) -> None:
        super().__init__()
        rospy.init_node("roslink_bridge", disable_signals=True)
        for topic, kind in ((SCAN, LaserScan), (IMAGE, CompressedImage), (MAP, OccupancyGrid)):
            self._keep(topic, kind)
        self._keep(self.BATTERY, BatteryState)
        rospy.Subscriber(self.ODOMETRY, Odometry, self._moved, queue_size=1)
        rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self._placed, queue_size=1)
        if TFMessage is not None:
            rospy.Subscriber("/tf", TFMessage, self._shifted, queue_size=10)
        self._speeds = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self._goal = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        self._cancel = rospy.Publisher("move_base/cancel", GoalID, queue_size=1) if GoalID else None

    def _keep(self, topic: str, kind: Any) -> None:
        rospy.Subscriber(topic, kind, self._keeper(topic), queue_size=1)

    def _seconds_of(self, message: Any) -> float:
        return float(message.header.stamp.to_sec())

    def drive(self, speeds: Speeds) -> None:
        twist = Twist()
        put(twist, speeds)
        self._speeds.publish(twist)

    def go_to(self, x: float, y: float) -> None:
        goal = self._aimed(PoseStamped(), x, y)
        goal.header.stamp = rospy.Time.now()
        self._goal.publish(goal)

    def cancel(self) -> None:
        if self._cancel is not None:
            self._cancel.publish(GoalID())
