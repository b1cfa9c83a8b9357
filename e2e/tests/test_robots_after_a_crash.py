"""The server killed with -9 while a robot behind our bridge is steered."""

import threading
from collections.abc import Iterator
from contextlib import closing

import pytest
from roslink_bridge.bridge import Bridge, Identity
from roslink_bridge.link import Link, UdpLink
from roslink_bridge.robot import Battery, Map, Pose, Scan, Speeds
from roslink_bridge.robot import Robot as BridgedRobot
from roslink_bridge.web import WebSocketLink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.steering_client import SteeringClient
from dronemap_e2e.waiting import wait_for

SYSTEM_ID = 3502
OFTEN = 0.005


class MotorRobot(BridgedRobot):
    """A robot that drives on with its last speeds for ever, as motors do."""

    def __init__(self) -> None:
        self.speed = 0.0

    def pose(self) -> Pose | None:
        return Pose(0, 0, 0, forward=self.speed)

    def scan(self) -> Scan | None:
        return None

    def image(self) -> bytes | None:
        return None

    def map(self) -> Map | None:
        return None

    def battery(self) -> Battery | None:
        return None

    def drive(self, speeds: Speeds) -> None:
        self.speed = speeds.forward

    def go_to(self, x: float, y: float) -> None:
        raise AssertionError("nobody sent it anywhere")

    def cancel(self) -> None:
        self.speed = 0.0


@pytest.fixture
def bridged_robot(killable_server: Server) -> Iterator[MotorRobot]:
    """On both of its links."""
    robot = MotorRobot()
    udp = UdpLink(("127.0.0.1", killable_server.robot_udp_port))
    web = WebSocketLink(f"ws://127.0.0.1:{killable_server.robot_web_port}/")
    link = Link(Bridge(Identity(SYSTEM_ID, "ours"), robot), udp, web)
    runner = threading.Thread(target=link.run)
    runner.start()
    yield robot
    link.end()
    runner.join()


def steerable(api: Api, system_id: int) -> Json:
    def look() -> Json | None:
        found = [drone for drone in api.drones() if drone["link"]["systemId"] == system_id]
        return found[0] if found and found[0]["actions"]["velocity"]["allowed"] else None

    return wait_for(f"robot {system_id} may be steered", look)


def linked(api: Api, drone: str) -> bool:
    link = api.drone(drone)["link"]
    return link["transport"] == "websocket" and len(link["others"]) == 1


def test_bridge_stops_robot_when_server_is_killed(killable_server: Server, bridged_robot: MotorRobot) -> None:
    """End to end because our bridge, a program of its own, sees a process killed, and dials again."""
    api = Api(killable_server.address, killable_server.local_key())
    drone = steerable(api, SYSTEM_ID)["id"]
    wait_for("it has both links", lambda: linked(api, drone))
    with closing(SteeringClient(killable_server, api.new_key("stick", "operator"), drone)):
        wait_for("it drives", lambda: bridged_robot.speed > 0.3, every=OFTEN)
        killable_server.kill()
        wait_for("it stands by itself", lambda: bridged_robot.speed == 0, every=OFTEN)

    killable_server.start()
    newer = Api(killable_server.address, killable_server.local_key())
    wait_for("it has both links again", lambda: linked(newer, drone), 30)
    assert bridged_robot.speed == 0
