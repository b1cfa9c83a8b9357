"""Records every datagram between vehicles and server, and reads messages and states from them later.

A relay that understands nothing but where a frame ends: what it means is decided later, from the bytes alone.
"""

import bisect
import select
import socket
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

Address = tuple[str, int]
MAVLINK_1, MAVLINK_2 = 0xFE, 0xFD
SIGNED = 1
UP_KINDS = frozenset(
    {
        mavlink.MAVLINK_MSG_ID_HEARTBEAT,
        mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT,
        mavlink.MAVLINK_MSG_ID_STATUSTEXT,
        mavlink.MAVLINK_MSG_ID_MISSION_CURRENT,
    }
)
ARMED = mavlink.MAV_MODE_FLAG_SAFETY_ARMED


@dataclass(frozen=True)
class Datagram:
    """Seconds are monotonic; what came down and was withheld is kept as well."""

    at: float
    up: bool
    vehicle: int
    data: bytes
    withheld: bool


@dataclass(frozen=True)
class TimedMessage:
    """A message of a datagram, with the time of the datagram."""

    at: float
    message: Any

    @property
    def kind(self) -> str:
        name: str = self.message.get_type()
        return name

    def __str__(self) -> str:
        fields = self.message.to_dict()
        fields.pop("mavpackettype")
        return f"{self.kind} {fields}"


class DatagramRecorder:
    """A UDP relay that records: vehicles connect to `port`, each has a socket towards the server."""

    def __init__(self, server_port: int) -> None:
        self._server: Address = ("127.0.0.1", server_port)
        self._vehicle_socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._vehicle_socket.bind(("127.0.0.1", 0))
        self._vehicle_socket.setblocking(False)
        self._vehicle_socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        self.port: int = self._vehicle_socket.getsockname()[1]
        self._vehicles: dict[int, Address] = {}
        self._upstream: dict[Address, socket.socket] = {}
        self._of: dict[socket.socket, tuple[Address, int]] = {}
        self._kept: list[Datagram] = []
        # Nothing of the server is passed on to these.
        self.withheld_from: set[int] = set()
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def inject(self, vehicle: int, data: bytes) -> None:
        """Sends as another ground station on the vehicle's own link; the server has no part in it."""
        self._vehicle_socket.sendto(data, self._vehicles[vehicle])

    def of(self, vehicle: int) -> "Log":
        return Log([one for one in list(self._kept) if one.vehicle == vehicle])

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        for upstream in self._upstream.values():
            upstream.close()
        self._vehicle_socket.close()

    def _run(self) -> None:
        while not self._closed:
            for ready in select.select([self._vehicle_socket, *self._of], [], [], 0.2)[0]:
                try:
                    data, sender = ready.recvfrom(65535)
                except (ConnectionError, BlockingIOError):
                    # The server is not there at the moment, which may have been told already.
                    continue
                if ready is self._vehicle_socket:
                    self._up(sender, data)
                else:
                    self._down(*self._of[ready], data)

    def _up(self, sender: Address, data: bytes) -> None:
        if sender not in self._upstream:
            vehicle = source(data)
            if vehicle is None:
                return
            opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            opened.setblocking(False)
            opened.connect(self._server)
            self._upstream[sender] = opened
            self._vehicles[vehicle] = sender
            self._of[opened] = (sender, vehicle)
        upstream = self._upstream[sender]
        self._keep(True, self._of[upstream][1], data, False)
        try:
            upstream.send(data)
        except ConnectionError:
            # As above: a vehicle does not notice.
            return

    def _down(self, vehicle: Address, number: int, data: bytes) -> None:
        withheld = number in self.withheld_from
        self._keep(False, number, data, withheld)
        if not withheld:
            self._vehicle_socket.sendto(data, vehicle)

    def _keep(self, up: bool, vehicle: int, data: bytes, withheld: bool) -> None:
        self._kept.append(Datagram(time.monotonic(), up, vehicle, data, withheld))


@dataclass(frozen=True)
class State:
    """State of a vehicle by its newest messages at that moment."""

    at: float
    mode: int
    armed: bool
    height: float
    speed: float
    text: str = ""


class Log:
    """Messages from and to one vehicle."""

    def __init__(self, datagrams: list[Datagram]) -> None:
        self._datagrams = datagrams

    @cached_property
    def states(self) -> list[State]:
        found: list[State] = []
        mode, armed, height, speed = -1, False, 0.0, 0.0
        for timed in self.up:
            message = timed.message
            if timed.kind == "HEARTBEAT":
                mode, armed = message.custom_mode, bool(message.base_mode & ARMED)
            elif timed.kind == "GLOBAL_POSITION_INT":
                height = message.relative_alt / 1000
                speed = (message.vx**2 + message.vy**2 + message.vz**2) ** 0.5 / 100
            else:
                continue
            if mode >= 0:
                found.append(State(timed.at, mode, armed, height, speed))
        return found

    @cached_property
    def up(self) -> list[TimedMessage]:
        return list(self._messages(True, UP_KINDS))

    @cached_property
    def down(self) -> list[TimedMessage]:
        """All that the server sent to it, also what never arrived."""
        return list(self._messages(False, None))

    def at(self, moment: float) -> State:
        """State at that moment."""
        times = [state.at for state in self.states]
        return self.states[max(0, bisect.bisect_right(times, moment) - 1)]

    def since(self, moment: float) -> list[State]:
        return [self.at(moment), *(state for state in self.states if state.at > moment)]

    def sent_since(self, since: float, *kinds: str) -> list[TimedMessage]:
        return [one for one in self.down if one.at >= since and (not kinds or one.kind in kinds)]

    def _messages(self, up: bool, wanted: frozenset[int] | None) -> Iterator[TimedMessage]:
        parser = mavlink.MAVLink(None)
        parser.robust_parsing = True
        for datagram in self._datagrams:
            if datagram.up != up:
                continue
            for number, frame in frames(datagram.data):
                if wanted is None or number in wanted:
                    for message in parser.parse_buffer(frame) or []:
                        yield TimedMessage(datagram.at, message)


def frames(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Each frame of a datagram with the number of its message (https://mavlink.io/en/guide/serialization.html)."""
    at = 0
    while at + 8 <= len(data):
        if data[at] == MAVLINK_2:
            length = data[at + 1] + 12 + (13 if data[at + 2] & SIGNED else 0)
            number = int.from_bytes(data[at + 7 : at + 10], "little")
        elif data[at] == MAVLINK_1:
            length, number = data[at + 1] + 8, data[at + 5]
        else:
            return
        yield number, data[at : at + length]
        at += length


def source(data: bytes) -> int | None:
    """The system id of the sender; None: no message, as the text that an autopilot begins with."""
    if data[0] == MAVLINK_2:
        return data[5]
    return data[3] if data[0] == MAVLINK_1 else None
