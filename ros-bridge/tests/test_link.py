"""The bridge on a real socket: it finds its cloud, and stands when the cloud is gone or it is ended."""

import json
import socket
import threading
import time
from typing import Any, Callable, Iterator

import pytest

from roslink_bridge.bridge import TWIST, Bridge, Identity
from roslink_bridge.link import Link, UdpLink
from roslink_bridge.robot import Speeds

from .stand_in import StandIn
from .test_bridge import twist

PATIENCE_SECONDS = 10


@pytest.fixture
def cloud() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as opened:
        opened.bind(("127.0.0.1", 0))
        opened.settimeout(PATIENCE_SECONDS)
        yield opened


def eventually(what: str, is_so: Callable[[], Any]) -> None:
    end = time.monotonic() + PATIENCE_SECONDS
    wait = threading.Event()
    while not is_so():
        assert time.monotonic() < end, f"never: {what}"
        wait.wait(0.005)


def test_udp_link_drives_and_stops_on_loss_and_end(cloud: socket.socket) -> None:
    robot = StandIn()
    link = Link(Bridge(Identity(7, "rk-secret"), robot), UdpLink(cloud.getsockname()))
    runner = threading.Thread(target=link.run)
    runner.start()
    try:
        data, there = cloud.recvfrom(65_535)
        assert json.loads(data)["header"]["message_id"] == 0
        cloud.sendto(b"\xff\xfe", there)
        cloud.sendto(twist(0.4).encode(), there)
        eventually("it drives", lambda: robot.driven == [Speeds(0.4)])
        begun = time.monotonic()
        cloud.close()
        eventually("it stops by itself", lambda: robot.driven[-1] == Speeds())
        assert time.monotonic() - begun < 1
        assert runner.is_alive(), "it goes on without a cloud"
    finally:
        link.end()
        runner.join()
    assert robot.driven[-1] == Speeds()
    assert robot.goals == [None]
    assert TWIST == 100
