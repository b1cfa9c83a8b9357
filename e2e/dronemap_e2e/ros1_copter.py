"""A copter of the tests with ROS 1, behind a stand-in for mavros: for the Python that has rospy.

It climbs and flies straight, and forgets speeds after three seconds, as ArduCopter does. Each order that it
hears is a line of JSON on its output.
"""

import math
from typing import Any

import rospy
from mavros_msgs.msg import Altitude, PositionTarget, State
from mavros_msgs.srv import CommandBool, CommandTOL, SetMode
from nav_msgs.msg import Odometry
from ros1_robot import print_order
from sensor_msgs.msg import BatteryState, NavSatFix
from std_msgs.msg import Float64, UInt32

HERTZ = 20
CLIMB = 3.0
STANDBY, ACTIVE = 3, 4
YAW = 0.5
AMSL, ELLIPSOID = 410.0, 457.0
SPEEDS_SECONDS = 3.0


class SimulatedCopter:
    """Orders come on rospy's threads, each replaces one value; the rest is the main thread's."""

    def __init__(self) -> None:
        rospy.init_node("mavros")
        self._armed, self._mode = False, "STABILIZE"
        self._height = self._wanted = 0.0
        self._x = self._y = 0.0
        self._speeds, self._since = (0.0, 0.0), 0.0
        self._publishers = {
            name: rospy.Publisher(f"mavros/{name}", kind, queue_size=1)
            for name, kind in (
                ("state", State),
                ("altitude", Altitude),
                ("battery", BatteryState),
                ("local_position/odom", Odometry),
                ("global_position/raw/fix", NavSatFix),
                ("global_position/raw/satellites", UInt32),
                ("global_position/rel_alt", Float64),
            )
        }
        rospy.Subscriber("mavros/setpoint_raw/local", PositionTarget, self._steer)
        rospy.Service("mavros/cmd/arming", CommandBool, self._arm)
        rospy.Service("mavros/set_mode", SetMode, self._set_mode)
        rospy.Service("mavros/cmd/takeoff", CommandTOL, self._take_off)
        rospy.Service("mavros/cmd/land", CommandTOL, self._land)

    def _arm(self, order: Any) -> Any:
        print_order("arm", wanted=order.value)
        allowed = order.value or self._height == 0
        self._armed = order.value if allowed else self._armed
        return CommandBool._response_class(success=allowed)

    def _set_mode(self, order: Any) -> Any:
        print_order("mode", name=order.custom_mode)
        self._mode = order.custom_mode
        return SetMode._response_class(mode_sent=True)

    def _take_off(self, order: Any) -> Any:
        print_order("take off", height=order.altitude)
        allowed = self._armed and self._mode == "GUIDED"
        self._wanted = order.altitude if allowed else self._wanted
        return CommandTOL._response_class(success=allowed)

    def _land(self, _: Any) -> Any:
        print_order("land")
        self._mode, self._wanted = "LAND", 0.0
        return CommandTOL._response_class(success=True)

    def _steer(self, target: Any) -> None:
        print_order("speeds", forward=target.velocity.x, frame=target.coordinate_frame, mask=target.type_mask)
        self._speeds, self._since = (target.velocity.x, target.velocity.y), 0.0

    def run(self) -> None:
        rate = rospy.Rate(HERTZ)
        while not rospy.is_shutdown():
            self._move(1 / HERTZ)
            self._report()
            rate.sleep()

    def _move(self, seconds: float) -> None:
        way = self._wanted - self._height
        self._height += math.copysign(min(abs(way), CLIMB * seconds), way)
        self._since += seconds
        if self._height == 0 or self._since > SPEEDS_SECONDS:
            self._speeds = (0.0, 0.0)
        forward, left = self._speeds
        self._x += (forward * math.cos(YAW) - left * math.sin(YAW)) * seconds
        self._y += (forward * math.sin(YAW) + left * math.cos(YAW)) * seconds

    def _report(self) -> None:
        system = ACTIVE if self._height > 0 else STANDBY
        self._publish(
            "state", State(connected=True, armed=self._armed, mode=self._mode, system_status=system)
        )
        self._publish("altitude", Altitude(amsl=AMSL + self._height))
        self._publish("battery", BatteryState(percentage=0.8, voltage=12.1, current=-3.5))
        place = Odometry()
        place.header.stamp, place.header.frame_id = rospy.Time.now(), "map"
        pose, twist = place.pose.pose, place.twist.twist
        pose.position.x, pose.position.y, pose.position.z = self._x, self._y, self._height
        pose.orientation.z, pose.orientation.w = math.sin(YAW / 2), math.cos(YAW / 2)
        twist.linear.x, twist.linear.y = self._speeds
        self._publish("local_position/odom", place)
        fix = NavSatFix(latitude=47.4, longitude=8.5, altitude=ELLIPSOID + self._height)
        self._publish("global_position/raw/fix", fix)
        self._publish("global_position/raw/satellites", UInt32(data=11))
        self._publish("global_position/rel_alt", Float64(data=self._height))

    def _publish(self, name: str, message: Any) -> None:
        self._publishers[name].publish(message)


if __name__ == "__main__":
    SimulatedCopter().run()
