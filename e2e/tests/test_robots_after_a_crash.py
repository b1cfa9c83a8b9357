"""The server killed with -9 while robots are steered: ours stop by themselves, others once it is back."""

import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing

import pytest
from roslink_bridge.bridge import Bridge, Identity
from roslink_bridge.link import Link, UdpLine
from roslink_bridge.robot import Battery, Map, Pose, Scan, Speeds
from roslink_bridge.robot import Robot as Machine
from roslink_bridge.web import WebLine

from dronemap_e2e.api import Api, Json
from dronemap_e2e.helm import Helm
from dronemap_e2e.robot import TWIST, Robot
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for

FOREIGN_ID, OUR_ID = 3501, 3502
MOST_SECONDS = 1.0
# Robots call in once a second, and the server takes them in as soon as it listens.
BACK_SECONDS = 3.0
OFTEN = 0.005


class Wheels(Machine):
    """Drives on with the last speeds for ever, as motors do."""

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
def foreign(own_server: Server) -> Iterator[Robot]:
    with closing(Robot(own_server.robot_udp_port, FOREIGN_ID, "forever")) as robot:
        yield robot


@pytest.fixture
def ours(own_server: Server) -> Iterator[Wheels]:
    """On both of its links."""
    wheels = Wheels()
    udp = UdpLine(("127.0.0.1", own_server.robot_udp_port))
    web = WebLine(f"ws://127.0.0.1:{own_server.robot_web_port}/")
    link = Link(Bridge(Identity(OUR_ID, "ours"), wheels), udp, web)
    runner = threading.Thread(target=link.run)
    runner.start()
    yield wheels
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


def test_a_server_that_dies_in_mid_twist_leaves_no_robot_driving(
    own_server: Server, foreign: Robot, ours: Wheels
) -> None:
    api = Api(own_server.address, own_server.local_key())
    key = api.new_key("stick", "operator")
    drones = [steerable(api, system_id)["id"] for system_id in (FOREIGN_ID, OUR_ID)]
    wait_for("ours has both links", lambda: linked(api, drones[1]))
    with ExitStack() as helms:
        for drone in drones:
            helms.enter_context(closing(Helm(own_server, key, drone)))
        wait_for("both drive", lambda: foreign.speed > 0.3 and ours.speed > 0.3, every=OFTEN)
        began = time.monotonic()
        own_server.kill()
        wait_for("ours stands by itself", lambda: ours.speed == 0, every=OFTEN)
        assert time.monotonic() - began <= MOST_SECONDS
    assert foreign.speed > 0.3, "it repeats what it heard last"

    heard = len(foreign.orders)
    own_server.start()
    began = time.monotonic()
    wait_for("the other one stands, too", lambda: foreign.speed == 0, every=OFTEN)
    print(f"it stood {time.monotonic() - began:.2f} s after the server was up")
    assert time.monotonic() - began <= BACK_SECONDS
    assert foreign.orders[heard] == TWIST, "first of all"
    newer = Api(own_server.address, own_server.local_key())
    wait_for("ours has both links again", lambda: linked(newer, drones[1]), 30)
    assert ours.speed == 0
