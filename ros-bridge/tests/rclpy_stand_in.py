"""Stand-ins for the parts of rclpy and of the messages of ROS 2 that the bridge uses."""

import sys
import threading
from types import ModuleType, SimpleNamespace
from typing import Any, Callable, Dict, Iterator, List, Tuple

KINDS = {
    "geometry_msgs.msg": ("PoseStamped", "PoseWithCovarianceStamped", "Twist"),
    "nav_msgs.msg": ("OccupancyGrid", "Odometry"),
    "sensor_msgs.msg": ("BatteryState", "CompressedImage", "LaserScan", "NavSatFix"),
    "std_msgs.msg": ("Float64", "UInt32"),
    "tf2_msgs.msg": ("TFMessage",),
    "mavros_msgs.msg": ("Altitude", "PositionTarget", "State"),
    "mavros_msgs.srv": ("CommandBool", "CommandTOL", "SetMode"),
}
MODULES = ("rclpy", "rclpy.qos", *KINDS)
ADAPTERS = ("roslink_bridge.ros2", "roslink_bridge.ros2_drone", "roslink_bridge.mavros_drone")


class Message:
    """Fields appear as they are used."""

    def __init__(self) -> None:
        self.__dict__["_fields"] = {}

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return self.__dict__["_fields"].setdefault(name, Message())

    def __setattr__(self, name: str, value: Any) -> None:
        self.__dict__["_fields"][name] = value


class Service:
    """Its requests are messages like others."""

    Request = Message


class Client:
    def __init__(self) -> None:
        self.asked: List[Any] = []
        self.ready = True

    def service_is_ready(self) -> bool:
        return self.ready

    def call_async(self, request: Any) -> None:
        self.asked.append(request)


class Publisher:
    def __init__(self) -> None:
        self.published: List[Any] = []

    def publish(self, message: Any) -> None:
        self.published.append(message)


class Node:
    def __init__(self) -> None:
        self.subscriptions: Dict[str, Tuple[Callable[[Any], None], Any]] = {}
        self.publishers: Dict[str, Publisher] = {}
        self.clients: Dict[str, Client] = {}

    def create_client(self, kind: Any, name: str) -> Client:
        return self.clients.setdefault(name, Client())

    def create_subscription(self, kind: Any, topic: str, callback: Callable[[Any], None], qos: Any) -> None:
        self.subscriptions[topic] = (callback, qos)

    def create_publisher(self, kind: Any, topic: str, depth: int) -> Publisher:
        return self.publishers.setdefault(topic, Publisher())

    def get_clock(self) -> Any:
        return SimpleNamespace(now=lambda: SimpleNamespace(to_msg=lambda: "now"))

    def deliver(self, topic: str, message: Any) -> None:
        self.subscriptions[topic][0](message)


def installed() -> Iterator[Node]:
    """The one node, with the stand-ins in the place of what is not there; as a fixture does."""
    node, spun = Node(), threading.Event()
    kept = {name: sys.modules.pop(name, None) for name in (*MODULES, *ADAPTERS)}
    made = {name: ModuleType(name) for name in MODULES}
    made["rclpy"].__dict__.update(
        init=lambda: None, create_node=lambda name: node, spin=lambda of: spun.set()
    )
    made["rclpy.qos"].__dict__.update(
        DurabilityPolicy=SimpleNamespace(TRANSIENT_LOCAL="latched"),
        QoSProfile=lambda depth, durability: (depth, durability),
        qos_profile_sensor_data="best effort",
    )
    for module, kinds in KINDS.items():
        made[module].__dict__.update(dict.fromkeys(kinds, Service if module.endswith("srv") else Message))
    sys.modules.update(made)
    try:
        yield node
        assert spun.wait(5), "nobody listens"
    finally:
        for name, before in kept.items():
            sys.modules.pop(name, None)
            if before is not None:
                sys.modules[name] = before
