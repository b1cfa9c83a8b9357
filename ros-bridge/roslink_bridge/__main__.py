"""roslink-bridge: starts on the robot, beside its ROS."""

import argparse
import signal
import sys
from typing import List, Optional

from .bridge import Bridge, Identity
from .link import UdpLink
from .robot import Robot


def main(arguments: Optional[List[str]] = None) -> int:
    options = _parser().parse_args(arguments)
    identity = Identity(
        options.system_id,
        options.key,
        options.owner,
        options.kind,
        options.name,
        options.fastest,
        options.turn,
    )
    link = UdpLink(Bridge(identity, robot(options.ros)), (options.host, options.port))
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: link.end())
    link.run()
    return 0


def robot(version: int) -> Robot:
    """The ROS packages are those of the machine; nothing else here needs them."""
    if version == 1:
        from .ros1 import Ros1Robot

        return Ros1Robot()
    from .ros2 import Ros2Robot

    return Ros2Robot()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="roslink-bridge", description=__doc__)
    parser.add_argument("host", help="where the cloud is")
    parser.add_argument("--port", type=int, default=25500, help="its UDP port (25500)")
    parser.add_argument("--ros", type=int, choices=(1, 2), required=True, help="which ROS the robot runs")
    parser.add_argument("--key", required=True, help="as the cloud issued it")
    parser.add_argument("--system-id", type=int, default=1, help="that the key was issued for (1)")
    parser.add_argument("--owner", default="", help="that the key was issued for, if any")
    parser.add_argument("--kind", type=int, default=8, help="8 TurtleBot, 12 RIA E100, 0 some other (8)")
    parser.add_argument("--name", default="robot")
    parser.add_argument(
        "--fastest", type=float, default=0.5, help="m/s that the cloud may ask for at most (0.5)"
    )
    parser.add_argument(
        "--turn", type=float, default=1.5, help="rad/s that the cloud may ask for at most (1.5)"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
