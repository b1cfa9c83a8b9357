"""What the bridge uses of rclpy and of the messages of ROS 2, as far as it can be had without them."""

import sys
import threading
from types import ModuleType, SimpleNamespace
from typing import Any, Callable, Dict, Iterator, List, Tuple

MODULES = ("rclpy", "rclpy.qos", "geometry_msgs.msg", "nav_msgs.msg", "sensor_msgs.msg")


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


class Publisher:
    def __init__(self) -> None:
        self.said: List[Any] = []

    def publish(self, message: Any) -> None:
        self.said.append(message)


class Node:
    def __init__(self) -> None:
        self.heard: Dict[str, Tuple[Callable[[Any], None], Any]] = {}
        self.publishers: Dict[str, Publisher] = {}

    def create_subscription(self, kind: Any, topic: str, callback: Callable[[Any], None], qos: Any) -> None:
        self.heard[topic] = (callback, qos)

    def create_publisher(self, kind: Any, topic: str, depth: int) -> Publisher:
        return self.publishers.setdefault(topic, Publisher())

    def get_clock(self) -> Any:
        return SimpleNamespace(now=lambda: SimpleNamespace(to_msg=lambda: "now"))

    def hears(self, topic: str, message: Any) -> None:
        self.heard[topic][0](message)


def installed() -> Iterator[Node]:
    """The one node, with the stand-ins in the place of what is not there; as a fixture does."""
    node, spun = Node(), threading.Event()
    kept = {name: sys.modules.pop(name, None) for name in (*MODULES, "roslink_bridge.ros2")}
    made = {name: ModuleType(name) for name in MODULES}
    made["rclpy"].__dict__.update(
        init=lambda: None, create_node=lambda name: node, spin=lambda of: spun.set()
    )
    made["rclpy.qos"].__dict__.update(
        DurabilityPolicy=SimpleNamespace(TRANSIENT_LOCAL="latched"),
        QoSProfile=lambda depth, durability: (depth, durability),
        qos_profile_sensor_data="best effort",
    )
    for module, kinds in (
        ("geometry_msgs.msg", ("PoseStamped", "Twist")),
        ("nav_msgs.msg", ("OccupancyGrid", "Odometry")),
        ("sensor_msgs.msg", ("BatteryState", "CompressedImage", "LaserScan")),
    ):
        made[module].__dict__.update(dict.fromkeys(kinds, Message))
    sys.modules.update(made)
    try:
        yield node
        assert spun.wait(5), "nobody listens"
    finally:
        for name, before in kept.items():
            sys.modules.pop(name, None)
            if before is not None:
                sys.modules[name] = before
