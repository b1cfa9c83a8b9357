"""Relays UDP between vehicles and server, and records every message of both directions."""

import select
import socket
import threading
import time
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, Protocol

from pymavlink.dialects.v20 import ardupilotmega as mavlink

Address = tuple[str, int]


@dataclass(frozen=True)
class RecordedMessage:
    """A message recorded on the wire; seconds are monotonic."""

    at: float
    up: bool
    message: Any
    # The system id of the vehicle that sent it or that it was sent to; None: it sent nothing yet.
    vehicle: int | None = None

    @property
    def kind(self) -> str:
        name: str = self.message.get_type()
        return name


class MessageLog(Protocol):
    """Recorded messages, of all vehicles or of one."""

    def messages(self, *kinds: str, up: bool | None = None, since: float = 0.0) -> list[RecordedMessage]: ...


class VehicleMessages:
    """Recorded messages from and to one vehicle."""

    def __init__(self, recorder: "MessageRecorder", vehicle: int) -> None:
        self._recorder = recorder
        self._vehicle = vehicle

    def messages(self, *kinds: str, up: bool | None = None, since: float = 0.0) -> list[RecordedMessage]:
        return [h for h in self._recorder.messages(*kinds, up=up, since=since) if h.vehicle == self._vehicle]


class MessageRecorder:
    """A UDP relay: vehicles connect to `port`, the server sees a socket per vehicle; keeps all messages."""

    def __init__(self, server_port: int, keep: Collection[str] = ()) -> None:
        """`keep`: of long runs only messages of these kinds; none named: all."""
        self._server: Address = ("127.0.0.1", server_port)
        self._kinds = frozenset(keep)
        # System ids of vehicles whose links are cut: their messages are recorded, and not passed on.
        self.cut: set[int] = set()
        self._systems: dict[Address, int] = {}
        self._vehicles = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._vehicles.bind(("127.0.0.1", 0))
        self.port: int = self._vehicles.getsockname()[1]
        self._upstream: dict[Address, socket.socket] = {}
        self._parsers: dict[tuple[Address, bool], Any] = {}
        self._messages: list[RecordedMessage] = []
        self._lock = threading.Lock()
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def messages(self, *kinds: str, up: bool | None = None, since: float = 0.0) -> list[RecordedMessage]:
        with self._lock:
            return [
                h
                for h in self._messages
                if (not kinds or h.kind in kinds) and (up is None or h.up == up) and h.at >= since
            ]

    def upstream_ports(self) -> set[int]:
        """The ports from which the server receives the vehicles' messages."""
        return {upstream.getsockname()[1] for upstream in list(self._upstream.values())}

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        for upstream in self._upstream.values():
            upstream.close()
        self._vehicles.close()

    def _run(self) -> None:
        while not self._closed:
            by_socket = {upstream: vehicle for vehicle, upstream in list(self._upstream.items())}
            readable, _, _ = select.select([self._vehicles, *by_socket], [], [], 0.2)
            for ready in readable:
                try:
                    data, sender = ready.recvfrom(65535)
                except ConnectionError:
                    continue
                up = ready is self._vehicles
                vehicle = sender if up else by_socket[ready]
                self._keep(vehicle, up, data)
                if self._systems.get(vehicle) in self.cut:
                    continue
                if up:
                    self._up(vehicle).sendto(data, self._server)
                else:
                    self._vehicles.sendto(data, vehicle)

    def _up(self, vehicle: Address) -> socket.socket:
        if vehicle not in self._upstream:
            upstream = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            upstream.bind(("127.0.0.1", 0))
            self._upstream[vehicle] = upstream
        return self._upstream[vehicle]

    def _keep(self, vehicle: Address, up: bool, data: bytes) -> None:
        parser = self._parsers.setdefault((vehicle, up), _parser())
        messages = parser.parse_buffer(data) or []
        now = time.monotonic()
        if up and messages:
            self._systems[vehicle] = messages[0].get_srcSystem()
        with self._lock:
            self._messages.extend(
                RecordedMessage(now, up, message, self._systems.get(vehicle))
                for message in messages
                if not self._kinds or message.get_type() in self._kinds
            )


def _parser() -> Any:
    parser = mavlink.MAVLink(None)
    parser.robust_parsing = True
    return parser
