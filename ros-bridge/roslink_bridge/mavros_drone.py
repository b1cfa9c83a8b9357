"""A drone behind mavros, read from its topics, in either version of ROS."""

from dataclasses import replace
from typing import Any, Optional, Tuple

from mavros_msgs.msg import Altitude, PositionTarget, State
from sensor_msgs.msg import NavSatFix
from std_msgs.msg import Float64, UInt32

from .mavros import fill_target, flight_of, satellites_of
from .robot import Flight, Flyer, Pose, Satellites, Speeds
from .topic_robot import TopicRobot

STATE, ALTITUDE, HEIGHT = "mavros/state", "mavros/altitude", "mavros/global_position/rel_alt"
FIX, VISIBLE = "mavros/global_position/raw/fix", "mavros/global_position/raw/satellites"


class MavrosDrone(TopicRobot, Flyer):
    """Its place is that of its flight controller, which localises itself."""

    ODOMETRY, BATTERY = "mavros/local_position/odom", "mavros/battery"
    TOPICS: Tuple[Tuple[str, Any], ...] = (
        (STATE, State),
        (ALTITUDE, Altitude),
        (FIX, NavSatFix),
        (VISIBLE, UInt32),
        (HEIGHT, Float64),
    )
    TARGET = "mavros/setpoint_raw/local"

    def pose(self) -> Optional[Pose]:
        pose, height = super().pose(), self._newest.get(HEIGHT)
        # Without a height it would pass for a robot on wheels.
        return None if pose is None or height is None else replace(pose, height=height.data)

    def flight(self) -> Optional[Flight]:
        return flight_of(self._newest.get(STATE))

    def satellites(self) -> Optional[Satellites]:
        newest = self._newest
        return satellites_of(newest.get(FIX), newest.get(VISIBLE), newest.get(ALTITUDE))

    def cancel(self) -> None:
        """It has been sent nowhere."""

    def _target(self, stamp: Any, speeds: Speeds) -> Any:
        target: Any = PositionTarget()
        target.header.stamp = stamp
        fill_target(target, speeds)
        return target
