"""The robot of the tests with ROS 1: a program of its own, for the Python that has rospy.

It moves as cmd_vel says, and on for ever; it goes straight to a goal. Its odometry began somewhere else than
its map, and AMCL says now and then where it is. Each order that it hears is a line of JSON on its output.
`python3 ros1_robot.py PICTURE` shows that picture as its camera's.
"""

import json
import math
import sys
from pathlib import Path
from typing import Any

import rospy
from actionlib_msgs.msg import GoalID
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import BatteryState, CompressedImage, LaserScan

HERTZ = 20
GOAL_SPEED = 2.0
#: Where its odometry began, on its map; a quarter turned to the left there.
BEGAN_X, BEGAN_Y, BEGAN_YAW = 1.5, -0.5, math.pi / 2


class SimulatedRobot:
    """Orders come on rospy's threads, each replaces one value; the rest is the main thread's."""

    def __init__(self, picture: bytes) -> None:
        rospy.init_node("machine")
        self._x = self._y = self._yaw = 0.0
        self._speeds = (0.0, 0.0)
        self._goal: tuple[float, float] | None = None
        self._picture = picture
        self._odometry = rospy.Publisher("odom", Odometry, queue_size=1)
        self._amcl = rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=1)
        self._scan = rospy.Publisher("scan", LaserScan, queue_size=1)
        self._camera = rospy.Publisher("camera/image/compressed", CompressedImage, queue_size=1)
        self._battery = rospy.Publisher("battery_state", BatteryState, queue_size=1)
        self._map = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        rospy.Subscriber("cmd_vel", Twist, self._drive)
        rospy.Subscriber("move_base_simple/goal", PoseStamped, self._go)
        rospy.Subscriber("move_base/cancel", GoalID, self._cancel)

    def _drive(self, twist: Any) -> None:
        self._speeds = (twist.linear.x, twist.angular.z)
        print_order("cmd_vel", forward=twist.linear.x, turn=twist.angular.z)

    def _go(self, goal: Any) -> None:
        place = goal.pose.position
        self._goal = (place.x, place.y)
        print_order("goal", x=place.x, y=place.y, frame=goal.header.frame_id)

    def _cancel(self, _: Any) -> None:
        self._goal = None
        print_order("cancel")

    def run(self) -> None:
        self._map.publish(room())
        rate = rospy.Rate(HERTZ)
        step = 0
        while not rospy.is_shutdown():
            forward = self._move(1 / HERTZ)
            self._odometry.publish(self._odometry_of(forward))
            if step % HERTZ == 0:
                self._amcl.publish(self._placed())
            if step % 4 == 0:
                self._scan.publish(sweep())
                self._camera.publish(CompressedImage(format="jpeg", data=self._picture))
                self._battery.publish(BatteryState(percentage=0.83))
            step += 1
            rate.sleep()

    def _move(self, seconds: float) -> float:
        goal = self._goal
        if goal is not None:
            left = math.dist(goal, (self._x, self._y))
            step = min(1.0, GOAL_SPEED * seconds / left) if left > 0 else 1.0
            self._x += (goal[0] - self._x) * step
            self._y += (goal[1] - self._y) * step
            if left < 0.01:
                self._goal = None
            return GOAL_SPEED if step < 1 else 0.0
        forward, turn = self._speeds
        self._x += forward * math.cos(self._yaw) * seconds
        self._y += forward * math.sin(self._yaw) * seconds
        self._yaw += turn * seconds
        return forward

    def _odometry_of(self, forward: float) -> Any:
        message = Odometry()
        message.header.stamp, message.header.frame_id = rospy.Time.now(), "odom"
        along, across = self._x - BEGAN_X, self._y - BEGAN_Y
        cos, sin = math.cos(BEGAN_YAW), math.sin(BEGAN_YAW)
        put(message.pose.pose, cos * along + sin * across, cos * across - sin * along, self._yaw - BEGAN_YAW)
        twist = message.twist.twist
        twist.linear.x, twist.angular.z = forward, self._speeds[1]
        return message

    def _placed(self) -> Any:
        message = PoseWithCovarianceStamped()
        message.header.stamp, message.header.frame_id = rospy.Time.now(), "map"
        put(message.pose.pose, self._x, self._y, self._yaw)
        return message


def put(pose: Any, x: float, y: float, yaw: float) -> None:
    pose.position.x, pose.position.y = x, y
    pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)


def sweep() -> Any:
    """Four rays: a wall, nothing, something too near to be measured, a wall."""
    scan = LaserScan(angle_min=-1.5, angle_increment=1.0, range_min=0.1, range_max=3.5)
    scan.ranges = [1.25, math.inf, 0.05, 2.5]
    return scan


def room() -> Any:
    """Three cells by two, of half a metre: from below, free, occupied, unknown; free, free, free."""
    grid = OccupancyGrid()
    grid.info.width, grid.info.height, grid.info.resolution = 3, 2, 0.5
    grid.info.origin.position.x, grid.info.origin.position.y = -1.0, -2.0
    grid.info.origin.orientation.w = 1.0
    grid.data = [0, 100, -1, 0, 0, 0]
    return grid


def print_order(what: str, **more: object) -> None:
    print(json.dumps({"what": what, **more}), flush=True)


if __name__ == "__main__":
    SimulatedRobot(Path(sys.argv[1]).read_bytes()).run()
