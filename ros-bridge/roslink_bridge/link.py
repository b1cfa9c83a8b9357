"""One UDP link to a cloud, which drives a bridge until it is told to end."""

import socket
import threading
import time
from typing import Tuple

from .bridge import Bridge

TURN_SECONDS = 0.02
LARGEST_DATAGRAM = 65_507


class UdpLink:
    """Carries what the bridge and the cloud say; the robot stands when it ends, however that comes."""

    def __init__(self, bridge: Bridge, server: Tuple[str, int]) -> None:
        self._bridge = bridge
        self._stop = threading.Event()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(server)
        self._socket.settimeout(TURN_SECONDS)
        #: What was too large for a datagram, or found no way out.
        self.dropped = 0

    def run(self) -> None:
        try:
            while not self._stop.is_set():
                for text in self._bridge.tick(time.monotonic()):
                    self._send(text)
                self._listen()
        finally:
            self._bridge.stop()
            self._socket.close()

    def end(self) -> None:
        """From any thread."""
        self._stop.set()

    def _listen(self) -> None:
        try:
            data = self._socket.recv(65_535)
        except socket.timeout:
            return
        except ConnectionRefusedError:
            # Nobody is there just now; the next heartbeat tries again.
            self._stop.wait(TURN_SECONDS)
            return
        for text in self._bridge.heard(data.decode("utf-8", "replace"), time.monotonic()):
            self._send(text)

    def _send(self, text: str) -> None:
        data = text.encode()
        if len(data) > LARGEST_DATAGRAM:
            self.dropped += 1
            return
        try:
            self._socket.send(data)
        except OSError:
            # The network is away; the robot is stopped by the bridge, and the next message tries again.
            self.dropped += 1
