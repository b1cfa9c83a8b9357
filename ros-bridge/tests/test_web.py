"""The bridge on a WebSocket, beside UDP and alone, with a cloud that comes and goes."""

import json
import socket
import threading
from contextlib import contextmanager
from typing import Any, Dict, Iterator, List, Optional

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import Server, ServerConnection, serve

from roslink_bridge.bridge import HEARTBEAT, MOTION, Bridge, Identity
from roslink_bridge.link import Link, UdpLink
from roslink_bridge.robot import Pose, Speeds
from roslink_bridge.web import MOST_WAITING, WebSocketLink

from .stand_in import StandIn
from .test_bridge import twist
from .test_link import PATIENCE_SECONDS, eventually


class Cloud:
    """A cloud that keeps what it receives by each way, and sends by its WebSocket."""

    def __init__(self) -> None:
        self.by_web: List[Dict[str, Any]] = []
        self.by_udp: List[Dict[str, Any]] = []
        self.connection: Optional[ServerConnection] = None
        self._server: Server = serve(self._receive, "127.0.0.1", 0)
        self._udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._udp.bind(("127.0.0.1", 0))
        self._udp.settimeout(0.1)
        self._ended = threading.Event()
        self._threads = [
            threading.Thread(target=self._server.serve_forever),
            threading.Thread(target=self._receive_udp),
        ]
        for thread in self._threads:
            thread.start()

    @property
    def web(self) -> str:
        return f"ws://127.0.0.1:{self._server.socket.getsockname()[1]}/"

    @property
    def udp(self) -> Any:
        return self._udp.getsockname()

    def _receive(self, connection: ServerConnection) -> None:
        self.connection = connection
        try:
            for text in connection:
                self.by_web.append(json.loads(text))
        except ConnectionClosed:
            return

    def _receive_udp(self) -> None:
        while not self._ended.is_set():
            try:
                self.by_udp.append(json.loads(self._udp.recv(65_535)))
            except socket.timeout:
                continue

    def close(self) -> None:
        self._ended.set()
        self._server.shutdown()
        for thread in self._threads:
            thread.join()
        self._udp.close()


@pytest.fixture
def cloud() -> Iterator[Cloud]:
    made = Cloud()
    yield made
    made.close()


@contextmanager
def running(link: Link) -> Iterator[None]:
    runner = threading.Thread(target=link.run)
    runner.start()
    try:
        yield
    finally:
        link.end()
        runner.join(PATIENCE_SECONDS)
        assert not runner.is_alive()


def kinds(messages: List[Dict[str, Any]]) -> List[int]:
    return [message["header"]["message_id"] for message in messages]


def test_web_socket_first_and_udp_while_it_is_down(cloud: Cloud) -> None:
    robot = StandIn()
    robot.newest_pose = Pose(1, 2, 0)
    bridge = Bridge(Identity(7, "rk-secret"), robot)
    with running(Link(bridge, UdpLink(cloud.udp), WebSocketLink(cloud.web))):
        eventually("it connects", lambda: MOTION in kinds(cloud.by_web))
        count = len(cloud.by_udp)
        eventually("it beats on both", lambda: HEARTBEAT in kinds(cloud.by_udp[count:]))
        assert MOTION not in kinds(cloud.by_udp[count:])
        assert cloud.connection
        cloud.connection.send(twist(0.4))
        eventually("it drives", lambda: Speeds(0.4) in robot.driven)
        eventually("it stops by itself", lambda: robot.driven[-1] == Speeds())

        cloud.connection.close()
        eventually("the rest goes by UDP", lambda: MOTION in kinds(cloud.by_udp[count:]))
        before = len(cloud.by_web)
        eventually("it comes back", lambda: MOTION in kinds(cloud.by_web[before:]))
    assert robot.goals == [None], "it stands when the link ends"


def test_web_socket_alone_is_enough(cloud: Cloud) -> None:
    robot = StandIn()
    with running(Link(Bridge(Identity(7, "rk-secret"), robot), None, WebSocketLink(cloud.web))):
        eventually("it connects", lambda: cloud.by_web)
        assert cloud.connection
        cloud.connection.send(twist(0.4))
        eventually("it drives", lambda: Speeds(0.4) in robot.driven)
    assert cloud.by_udp == []


def test_blocked_network_blocks_no_caller() -> None:
    with socket.create_server(("127.0.0.1", 0)) as deaf:
        line = WebSocketLink(f"ws://127.0.0.1:{deaf.getsockname()[1]}/")
        assert not line.send("a message"), "there is no answer to its greeting"
        line._up.set()
        for _ in range(MOST_WAITING + 3):
            assert line.send("a message")
        assert line.dropped == 3
        line.close()
