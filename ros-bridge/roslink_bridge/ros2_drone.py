"""A drone behind mavros with ROS 2: its topics, and its services, which answer some time later."""

import logging
from typing import Any

from mavros_msgs.msg import PositionTarget
from mavros_msgs.srv import CommandBool, CommandTOL, SetMode
from rclpy.qos import qos_profile_sensor_data

from .mavros import MODES
from .mavros_drone import MavrosDrone
from .robot import Speeds
from .ros2 import Ros2Robot

LOG = logging.getLogger(__name__)


class Ros2Drone(MavrosDrone, Ros2Robot):
    def _begin(self) -> None:
        for topic, kind in self.TOPICS:
            self._node.create_subscription(kind, topic, self._newest_callback(topic), qos_profile_sensor_data)
        self._aim = self._node.create_publisher(PositionTarget, self.TARGET, 1)
        self._arm = self._node.create_client(CommandBool, "mavros/cmd/arming")
        self._mode = self._node.create_client(SetMode, "mavros/set_mode")
        self._take_off = self._node.create_client(CommandTOL, "mavros/cmd/takeoff")
        self._land = self._node.create_client(CommandTOL, "mavros/cmd/land")
        super()._begin()

    def drive(self, speeds: Speeds) -> None:
        self._aim.publish(self._target(self._now(), speeds))

    def arm(self, wanted: bool) -> None:
        request: Any = CommandBool.Request()
        request.value = wanted
        self._ask("arming" if wanted else "disarming", self._arm, request)

    def set_mode(self, number: int) -> None:
        name = MODES.get(number)
        if name is not None:
            request: Any = SetMode.Request()
            request.custom_mode = name
            self._ask(name, self._mode, request)

    def take_off(self, height: float) -> None:
        request: Any = CommandTOL.Request()
        request.altitude = float(height)
        self._ask("taking off", self._take_off, request)

    def land(self) -> None:
        self._ask("landing", self._land, CommandTOL.Request())

    def _ask(self, what: str, service: Any, request: Any) -> None:
        """Nothing waits for the answer: the cloud looks at what the drone reports, and asks again."""
        if service.service_is_ready():
            service.call_async(request)
        else:
            LOG.warning("There is no service of mavros for %s", what)
