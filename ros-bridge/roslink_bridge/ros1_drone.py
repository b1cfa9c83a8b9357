"""A drone behind mavros with ROS 1: its topics, and its services, which are called apart."""

import rospy
from mavros_msgs.msg import PositionTarget
from mavros_msgs.srv import CommandBool, CommandTOL, SetMode

from .calls import ServiceCalls
from .mavros import MODES
from .mavros_drone import MavrosDrone
from .robot import Speeds
from .ros1 import Ros1Robot


class Ros1Drone(MavrosDrone, Ros1Robot):
    def __init__(self) -> None:
        super().__init__()
        for topic, kind in self.TOPICS:
            self._subscribe(topic, kind)
        self._aim = rospy.Publisher(self.TARGET, PositionTarget, queue_size=1)
        self._arm = rospy.ServiceProxy("mavros/cmd/arming", CommandBool)
        self._mode = rospy.ServiceProxy("mavros/set_mode", SetMode)
        self._take_off = rospy.ServiceProxy("mavros/cmd/takeoff", CommandTOL)
        self._land = rospy.ServiceProxy("mavros/cmd/land", CommandTOL)
        self._calls = ServiceCalls((rospy.ServiceException, rospy.ROSException))

    def drive(self, speeds: Speeds) -> None:
        self._aim.publish(self._target(rospy.Time.now(), speeds))

    def arm(self, wanted: bool) -> None:
        self._calls.ask("arming" if wanted else "disarming", lambda: self._arm(value=wanted).success)

    def set_mode(self, number: int) -> None:
        name = MODES.get(number)
        if name is not None:
            self._calls.ask(name, lambda: self._mode(base_mode=0, custom_mode=name).mode_sent)

    def take_off(self, height: float) -> None:
        self._calls.ask("taking off", lambda: self._take_off(altitude=height).success)

    def land(self) -> None:
        self._calls.ask("landing", lambda: self._land().success)
