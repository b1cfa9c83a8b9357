"""
A NAT of our own: new addresses for vehicles every few seconds; records what still comes to old ones.

Only from the server that it leads to: a fresh port may have been that of an earlier test's vehicle, to which
another server still speaks.
"""

import selectors
import socket
import threading
import time
from dataclasses import dataclass, field

LOOPBACK = "127.0.0.1"


@dataclass
class Mapping:
    """One vehicle behind the NAT: the address that the server sees now, and those that it saw before."""

    inside: tuple[str, int]
    outside: socket.socket
    since: float = field(default_factory=time.monotonic)
    left: list[tuple[socket.socket, float]] = field(default_factory=list)

    @property
    def port(self) -> int:
        port: int = self.outside.getsockname()[1]
        return port


class Nat:
    """Vehicles call `port`; each has an address of its own outside, for `seconds` each."""

    def __init__(self, server_port: int, seconds: float) -> None:
        self.seconds = seconds
        self.changes = 0
        # What came to an address after it was left: how many seconds after, and the bytes.
        self.late: list[tuple[float, bytes]] = []
        self._server = (LOOPBACK, server_port)
        self._mappings: dict[tuple[str, int], Mapping] = {}
        self._selector = selectors.DefaultSelector()
        self._front = self._open(None)
        self.port: int = self._front.getsockname()[1]
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        for key in list(self._selector.get_map().values()):
            assert isinstance(key.fileobj, socket.socket)
            key.fileobj.close()
        self._selector.close()

    def _open(self, mapping: Mapping | None) -> socket.socket:
        opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        opened.bind((LOOPBACK, 0))
        self._selector.register(opened, selectors.EVENT_READ, mapping)
        return opened

    def _run(self) -> None:
        while not self._closed:
            for key, _ in self._selector.select(0.05):
                assert isinstance(key.fileobj, socket.socket)
                try:
                    data, sender = key.fileobj.recvfrom(65535)
                except ConnectionError:
                    continue
                if key.data is None:
                    self._up(sender, data)
                elif sender == self._server:
                    self._down(key.fileobj, key.data, data)

    def _up(self, sender: tuple[str, int], data: bytes) -> None:
        mapping = self._mappings.get(sender)
        if mapping is None:
            mapping = self._mappings[sender] = Mapping(sender, self._front)
            self._change(mapping)
        elif time.monotonic() - mapping.since >= self.seconds:
            mapping.left.append((mapping.outside, time.monotonic()))
            self._change(mapping)
            self.changes += 1
        mapping.outside.sendto(data, self._server)

    def _change(self, mapping: Mapping) -> None:
        mapping.outside = self._open(mapping)
        mapping.since = time.monotonic()

    def _down(self, outside: socket.socket, mapping: Mapping, data: bytes) -> None:
        if outside is mapping.outside:
            self._front.sendto(data, mapping.inside)
            return
        left = next(when for old, when in mapping.left if old is outside)
        self.late.append((time.monotonic() - left, data))
