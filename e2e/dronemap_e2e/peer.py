"""A vehicle made with pymavlink, whose answers a test chooses, rightly or not."""

import socket
import struct
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from pymavlink.dialects.v10 import ardupilotmega as mavlink1
from pymavlink.dialects.v20 import ardupilotmega as mavlink

Handler = Callable[["Peer", Any], None]

ACCEPTED = mavlink.MAV_RESULT_ACCEPTED

# Of Linux; Python has no name for it.
SO_TIMESTAMPNS = 35


@dataclass(frozen=True)
class Kind:
    """Type, autopilot, MAVLink version and component of a peer."""

    type: int = mavlink.MAV_TYPE_QUADROTOR
    autopilot: int = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA
    version: int = 2
    component: int = 1


@dataclass
class State:
    """State that a peer reports, and the messages that it received."""

    armed: bool = False
    base_mode: int = mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
    custom_mode: int = 0
    status: int = mavlink.MAV_STATE_STANDBY
    received: list[Any] = field(default_factory=list)


class Peer:
    """Heartbeats each half second; answers what `handlers` (by message name) know and is silent else."""

    def __init__(
        self,
        port: int,
        system_id: int = 1,
        kind: Kind | None = None,
        handlers: Mapping[str, Handler] | None = None,
        tcp: bool = False,
    ) -> None:
        self.kind = kind or Kind()
        self.state = State()
        self.handlers = handlers or {}
        self._tcp = tcp
        self._to = port
        self._socket = self._open(port)
        self.port: int = self._socket.getsockname()[1]
        dialect = mavlink if self.kind.version == 2 else mavlink1
        self.link: Any = dialect.MAVLink(self, srcSystem=system_id, srcComponent=self.kind.component)
        self.link.robust_parsing = True
        self.silent = False
        self.arrived = 0.0
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def write(self, data: bytes) -> None:
        """pymavlink sends through this."""
        if not self.silent:
            self._socket.send(data)

    def received(self, *kinds: str) -> list[Any]:
        return [m for m in list(self.state.received) if m.get_type() in kinds]

    def commands(self, number: int) -> list[Any]:
        return [m for m in self.received("COMMAND_LONG", "COMMAND_INT") if m.command == number]

    def acknowledge(self, message: Any, result: int = ACCEPTED) -> None:
        self.link.command_ack_send(message.command, result)

    def send_text(self, text: str, severity: int = mavlink.MAV_SEVERITY_CRITICAL) -> None:
        self.link.statustext_send(severity, text.encode())

    def beat(self) -> None:
        armed = mavlink.MAV_MODE_FLAG_SAFETY_ARMED if self.state.armed else 0
        self.link.heartbeat_send(
            self.kind.type,
            self.kind.autopilot,
            self.state.base_mode | armed,
            self.state.custom_mode,
            self.state.status,
        )

    def move(self) -> "Peer.FormerAddress":
        """Goes on from another address, as behind a NAT that forgot; keeps what comes to the old one."""
        old = self._socket
        self._socket = self._open(self._to)
        self.port = self._socket.getsockname()[1]
        return Peer.FormerAddress(old)

    class FormerAddress:
        """An address that was left: who may still be spoken to there, and when."""

        def __init__(self, old: socket.socket) -> None:
            self._old = old
            self._link: Any = mavlink.MAVLink(None)
            self._link.robust_parsing = True
            self._left = time.monotonic()
            self.late: list[tuple[float, Any]] = []
            self._closed = False
            self._thread = threading.Thread(target=self._listen, daemon=True)
            self._thread.start()

        def _listen(self) -> None:
            while not self._closed:
                try:
                    data = self._old.recv(65535)
                except (TimeoutError, ConnectionError):
                    continue
                for message in self._link.parse_buffer(data) or []:
                    self.late.append((time.monotonic() - self._left, message))

        def close(self) -> None:
            self._closed = True
            self._thread.join()
            self._old.close()

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        self._socket.close()

    def run_step(self) -> None:
        """Called again and again on the peer's thread; kinds of peers do more here."""

    def _receive(self) -> bytes:
        """Reads data, and notes when it came to the socket by the system's time stamp."""
        data, more, _, _ = self._socket.recvmsg(65535, 64)
        stamps = [each for level, kind, each in more if (level, kind) == (socket.SOL_SOCKET, SO_TIMESTAMPNS)]
        if stamps:
            seconds, nanos = struct.unpack("qq", stamps[0][:16])
            self.arrived = seconds + nanos / 1e9
        return data

    def _open(self, port: int) -> socket.socket:
        opened = socket.socket(socket.AF_INET, socket.SOCK_STREAM if self._tcp else socket.SOCK_DGRAM)
        opened.setsockopt(socket.SOL_SOCKET, SO_TIMESTAMPNS, 1)
        opened.connect(("127.0.0.1", port))
        opened.settimeout(0.05)
        return opened

    def _run(self) -> None:
        next_beat = 0.0
        while not self._closed:
            self.run_step()
            if time.monotonic() >= next_beat:
                self.beat()
                next_beat = time.monotonic() + 0.5
            try:
                data = self._receive()
            except (TimeoutError, ConnectionError):
                continue
            for message in self.link.parse_buffer(data) or []:
                self.state.received.append(message)
                handler = self.handlers.get(message.get_type())
                if handler:
                    handler(self, message)


def apply_command(peer: Peer, message: Any) -> None:
    """Arms, disarms, changes mode and refuses the rest, as an autopilot on the ground would."""
    if message.command == mavlink.MAV_CMD_COMPONENT_ARM_DISARM:
        peer.state.armed = message.param1 == 1
    elif message.command == mavlink.MAV_CMD_DO_SET_MODE:
        set_mode(peer, int(message.param2), int(message.param3))
    else:
        peer.acknowledge(message, mavlink.MAV_RESULT_UNSUPPORTED)
        return
    peer.acknowledge(message)
    peer.beat()


def set_mode(peer: Peer, mode: int, sub_mode: int) -> None:
    px4 = peer.kind.autopilot == mavlink.MAV_AUTOPILOT_PX4
    peer.state.custom_mode = (mode << 16) | (sub_mode << 24) if px4 else mode


def set_mode_message(peer: Peer, message: Any) -> None:
    """The old SET_MODE message."""
    peer.state.custom_mode = message.custom_mode
    peer.beat()


def reporting_hardware(uid: int, then: Handler = apply_command) -> Handler:
    """Says which board it is when asked; does with the rest what `then` does."""

    def answer(peer: Peer, message: Any) -> None:
        if message.command == mavlink.MAV_CMD_REQUEST_MESSAGE and message.param1 == 148:
            peer.link.autopilot_version_send(0, 0x040506FF, 0, 0, 0, bytes(8), bytes(8), bytes(8), 0, 0, uid)
        else:
            then(peer, message)

    return answer


STANDARD_HANDLERS: dict[str, Handler] = {
    "COMMAND_LONG": apply_command,
    "COMMAND_INT": apply_command,
    "SET_MODE": set_mode_message,
}
