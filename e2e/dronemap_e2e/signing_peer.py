"""A vehicle that signs, with pymavlink's own implementation of signing."""

import hashlib
import queue
import time
from collections.abc import Callable
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .peer import OBEDIENT, Handler, Peer

TICKS_PER_SECOND = 100_000
EPOCH_2015 = 1_420_070_400
MINUTE = 60 * TICKS_PER_SECOND


def now_ticks() -> int:
    return int((time.time() - EPOCH_2015) * TICKS_PER_SECOND)


class SigningPeer(Peer):
    """Takes a key as ArduPilot does; all its sending is on its own thread, so that its timestamps rise."""

    def __init__(self, port: int, system_id: int, handlers: dict[str, Handler] | None = None) -> None:
        self.sent = 0
        self.streaming = False
        self.takes_keys = True
        self.slow_seconds = 0.0
        self.keys: list[bytes] = []
        self.written: list[bytes] = []
        self._slow_until = 0.0
        self._under_way: list[bytes] = []
        self._tasks: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        super().__init__(
            port, system_id=system_id, handlers=OBEDIENT | {"SETUP_SIGNING": take_key} | (handlers or {})
        )

    def do(self, task: Callable[[], None]) -> None:
        """Runs on the peer's thread."""
        self._tasks.put(task)

    def turn(self) -> None:
        while not self._tasks.empty():
            self._tasks.get()()
        self.arrive()
        if self.streaming:
            for number in range(5):
                self.link.attitude_send(number, 0, 0, 0, 0, 0, 0)

    def write(self, data: bytes) -> None:
        if not self.silent:
            self.sent += 1
            self.written.append(bytes(data))
            self._under_way.append(bytes(data))
            self.arrive()

    def slow_down(self) -> None:
        """What is sent in the next moment arrives at its end only."""
        self._slow_until = time.monotonic() + self.slow_seconds

    def arrive(self) -> None:
        if time.monotonic() >= self._slow_until:
            for data in self._under_way:
                self._socket.send(data)
            self._under_way.clear()

    def write_raw(self, data: bytes) -> None:
        """Bytes as they are, not counted."""
        self._socket.send(data)

    def use_key(self, key: bytes, timestamp: int, link_id: int = 0) -> None:
        """Signs from now on, and listens to nothing else; on the peer's thread."""
        self.link.signing.secret_key = key
        self.link.signing.sign_outgoing = True
        self.link.signing.timestamp = timestamp
        self.link.signing.link_id = link_id
        self.link.signing.allow_unsigned_callback = None

    def refused(self) -> int:
        """Frames of the server that pymavlink did not take for signed rightly."""
        return int(self.link.signing.badsig_count)

    def gaps(self) -> int:
        """Frames of the server that are missing between those that came."""
        numbers = [m.get_seq() for m in list(self.state.received) if m.get_srcSystem() == 255]
        pairs = zip(numbers, numbers[1:], strict=False)
        return sum((after - before - 1) % 256 for before, after in pairs)


def take_key(peer: Peer, message: Any) -> None:
    """As ArduPilot: at once, with a time a minute after the one that came along; zeros end it."""
    assert isinstance(peer, SigningPeer)
    key = bytes(message.secret_key)
    peer.keys.append(key)
    if not peer.takes_keys:
        return
    peer.slow_down()
    if any(key):
        peer.use_key(key, message.initial_timestamp + MINUTE)
    else:
        peer.link.signing.secret_key = None
        peer.link.signing.sign_outgoing = False


def resigned(frame: bytes, key: bytes, timestamp: int, link_id: int) -> bytes:
    """The same signed frame with another signature."""
    assert frame[0] == mavlink.PROTOCOL_MARKER_V2 and frame[2] & 1, "not a signed frame"
    body = frame[:-13] + bytes([link_id]) + timestamp.to_bytes(6, "little")
    return body + hashlib.sha256(key + body).digest()[:6]
