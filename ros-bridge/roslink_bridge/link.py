"""The links to a cloud, which drive a bridge until it is ended."""

import socket
import threading
import time
from typing import List, Optional, Tuple

from .bridge import HEARTBEAT, Bridge, OutgoingMessage
from .web import WebSocketLink

STEP_SECONDS = 0.02
LARGEST_DATAGRAM = 65_507


class UdpLink:
    """Datagrams to and from one server."""

    def __init__(self, server: Tuple[str, int]) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(server)
        self._socket.settimeout(STEP_SECONDS)
        #: What was too large for a datagram, or found no way out.
        self.dropped = 0

    def receive(self, ended: threading.Event) -> List[str]:
        """Waits for a moment."""
        try:
            return [self._socket.recv(65_535).decode("utf-8", "replace")]
        except socket.timeout:
            return []
        except ConnectionRefusedError:
            # Nobody is there just now; the next heartbeat tries again.
            ended.wait(STEP_SECONDS)
            return []

    def send(self, text: str) -> None:
        data = text.encode()
        if len(data) > LARGEST_DATAGRAM:
            self.dropped += 1
            return
        try:
            self._socket.send(data)
        except OSError:
            # The network is away; the robot is stopped by the bridge, and the next message tries again.
            self.dropped += 1

    def close(self) -> None:
        self._socket.close()


class Link:
    """Carries messages between bridge and cloud; the robot stops when it ends, however that comes.

    Where there is a WebSocket all goes there, and heartbeats by UDP, too; while it is down, all goes by UDP.
    """

    def __init__(self, bridge: Bridge, udp: Optional[UdpLink], web: Optional[WebSocketLink] = None) -> None:
        self._bridge = bridge
        self._udp = udp
        self._web = web
        self._stop = threading.Event()

    def run(self) -> None:
        try:
            while not self._stop.is_set():
                self._send(self._bridge.step(time.monotonic()))
                for text in self._receive():
                    self._send(self._bridge.receive(text, time.monotonic()))
        finally:
            self._bridge.stop()
            for line in (self._udp, self._web):
                if line is not None:
                    line.close()

    def end(self) -> None:
        """From any thread."""
        self._stop.set()

    def _receive(self) -> List[str]:
        received = [] if self._udp is None else self._udp.receive(self._stop)
        if self._web is not None:
            if self._udp is None:
                self._stop.wait(STEP_SECONDS)
            received += self._web.receive()
        return received

    def _send(self, messages: List[OutgoingMessage]) -> None:
        for one in messages:
            by_web = self._web is not None and self._web.send(one.text)
            if self._udp is not None and (not by_web or one.kind == HEARTBEAT):
                self._udp.send(one.text)
