"""roslink-bridge: starts on the robot, beside its ROS."""

import argparse
import signal
import sys
from typing import List, Optional

from .bridge import Bridge, Identity
from .link import Link, UdpLink
from .robot import Flyer, Robot
from .web import WebSocketLink

ROBOT, DRONE = 8, 3


def main(arguments: Optional[List[str]] = None) -> int:
    options = _parser().parse_args(arguments)
    identity = Identity(
        options.system_id,
        options.key,
        options.owner,
        options.kind if options.kind is not None else DRONE if options.mavros else ROBOT,
        options.name,
        options.fastest if options.fastest is not None else 3.0 if options.mavros else 0.5,
        options.turn,
        options.highest,
    )
    web = WebSocketLink(options.web) if options.web else None
    # What a safe connection keeps to itself no datagram shall tell.
    apart = options.web.startswith("wss:")
    link = Link(
        bridge(identity, options.ros, options.mavros),
        None if apart else UdpLink((options.host, options.port)),
        web,
    )
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: link.end())
    link.run()
    return 0


def bridge(identity: Identity, version: int, mavros: bool) -> Bridge:
    if mavros:
        from .flying import FlyingBridge

        return FlyingBridge(identity, drone(version))
    return Bridge(identity, robot(version))


def robot(version: int) -> Robot:
    """The ROS packages are those of the machine; nothing else here needs them."""
    if version == 1:
        from .ros1 import Ros1Robot

        return Ros1Robot()
    from .ros2 import Ros2Robot

    return Ros2Robot()


def drone(version: int) -> Flyer:
    if version == 1:
        from .ros1_drone import Ros1Drone

        return Ros1Drone()
    from .ros2_drone import Ros2Drone

    return Ros2Drone()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="roslink-bridge", description=__doc__)
    parser.add_argument("host", help="where the cloud is")
    parser.add_argument("--port", type=int, default=25500, help="its UDP port (25500)")
    parser.add_argument("--ros", type=int, choices=(1, 2), required=True, help="which ROS the robot runs")
    parser.add_argument("--key", required=True, help="as the cloud issued it")
    parser.add_argument("--system-id", type=int, default=1, help="that the key was issued for (1)")
    parser.add_argument("--owner", default="", help="that the key was issued for, if any")
    parser.add_argument("--mavros", action="store_true", help="it is a drone behind mavros (ArduCopter)")
    parser.add_argument(
        "--web", default="", help="its WebSocket, such as ws://HOST:9090/; with wss:// nothing goes by UDP"
    )
    parser.add_argument(
        "--kind",
        type=int,
        help="8 TurtleBot (usual), 12 RIA E100, 0 some other; drones: 3 with four rotors (usual), 6 with six",
    )
    parser.add_argument("--name", default="robot")
    parser.add_argument(
        "--fastest", type=float, help="m/s that the cloud may ask for at most (0.5, drones 3)"
    )
    parser.add_argument(
        "--turn", type=float, default=1.5, help="rad/s that the cloud may ask for at most (1.5)"
    )
    parser.add_argument(
        "--highest", type=float, default=30.0, help="m that a drone takes off to at most (30)"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
