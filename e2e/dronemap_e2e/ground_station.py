"""A ground station of another maker, with pymavlink's own signing, attached to the outlet."""

import hashlib
import os
import secrets
import threading
import time
from collections.abc import Callable
from typing import Any, NamedTuple

os.environ.setdefault("MAVLINK20", "1")

from pymavlink import mavutil

from . import control_status as control_status  # makes it known to pymavlink
from .api import Api
from .server import Server
from .waiting import wait_for

GROUND_STATION = 6
NO_AUTOPILOT = 8


class User(NamedTuple):
    """Somebody with a passphrase."""

    name: str
    api: Api
    passphrase: str


def new_user(server: Server, api: Api, role: str) -> User:
    """A user who has signed in once and set a passphrase."""
    name, first, own = f"{role}-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": first, "role": role})
    assert answer.status_code == 201, answer.text
    session = Api(server.address)
    assert session.call("POST", "/session", {"name": name, "password": first}).ok
    answer = session.call("POST", "/session/password", {"current": first, "next": own})
    assert answer.status_code == 204, answer.text
    answer = session.call("PUT", "/outlet/passphrase", {})
    assert answer.ok, answer.text
    return User(name, session, str(answer.json()["passphrase"]))


def granted(server: Server, api: Api, role: str, drones: list[str]) -> User:
    """A user who sees these drones and no other drone."""
    user = new_user(server, api, role)
    assert api.call("PUT", f"/users/{user.name}/only-granted", {"onlyGranted": True}).status_code == 204
    operations = ["view"] if role == "viewer" else ["view", "plan", "command"]
    body = {"user": user.name, "drones": drones, "operations": operations}
    assert api.call("POST", "/grants", body).status_code == 201
    return user


class GroundStation:
    """A ground station: heartbeats twice a second, keeps all messages, signs if it has a passphrase."""

    def __init__(self, address: str, passphrase: str | None, system_id: int = 255) -> None:
        self.link: Any = mavutil.mavlink_connection(
            address, source_system=system_id, source_component=190, dialect="ardupilotmega"
        )
        if address.startswith("udpout:"):
            # Vehicles and servers of other tests may still speak to whoever had this port before.
            self.link.port.connect(self.link.destination_addr)
        if passphrase is not None:
            key = hashlib.sha256(passphrase.encode()).digest()
            self.link.setup_signing(key, sign_outgoing=True, allow_unsigned_callback=lambda *_: False)
        self.all_messages: list[Any] = []
        self.arrived: dict[int, float] = {}
        self.silent = False
        self._lock = threading.Lock()
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        beat = 0.0
        while not self._closed:
            if time.monotonic() - beat > 0.5 and not self.silent:
                beat = time.monotonic()
                self.send_fields("heartbeat", GROUND_STATION, NO_AUTOPILOT, 0, 0, 4)
            try:
                message = self.link.recv_match(blocking=True, timeout=0.05)
            except (ConnectionError, OSError):
                return
            if message is not None and message.get_type() != "BAD_DATA":
                self.arrived[message.get_srcSystem()] = time.monotonic()
                self.all_messages.append(message)

    def send_fields(self, message: str, *fields: Any) -> None:
        """Sends what pymavlink calls `message`_send."""
        with self._lock:
            getattr(self.link.mav, f"{message}_send")(*fields)

    def send(self, message: Any) -> None:
        """Sends a message that pymavlink has made."""
        with self._lock:
            self.link.mav.send(message)

    def messages(self, kind: str, system_id: int | None = None) -> list[Any]:
        return [
            m
            for m in list(self.all_messages)
            if m.get_type() == kind and system_id in (None, m.get_srcSystem())
        ]

    def vehicles(self) -> set[int]:
        """The system ids of all vehicles whose heartbeats were received."""
        beats = self.messages("HEARTBEAT")
        return {m.get_srcSystem() for m in beats if m.type != GROUND_STATION}

    def wait_vehicles(self, count: int = 1, seconds: float = 20) -> set[int]:
        return wait_for(
            f"{count} vehicles are heard",
            lambda: self.vehicles() if len(self.vehicles()) >= count else None,
            seconds,
        )

    def gaps(self, system_id: int) -> int:
        """Messages that are missing from the numbers of the autopilot's."""
        numbers = [
            m.get_seq()
            for m in list(self.all_messages)
            if m.get_srcSystem() == system_id and m.get_srcComponent() == 1
        ]
        pairs = zip(numbers, numbers[1:], strict=False)
        return sum((after - before - 1) % 256 for before, after in pairs)

    def command(self, number: int, command: int, *params: float, seconds: float = 30) -> int:
        """Sends that system a command as a ground station does; the result that it is acknowledged with."""
        before = len(self.messages("COMMAND_ACK", number))
        values = [*params, *([0.0] * (7 - len(params)))]
        self.send_fields("command_long", number, 1, command, 0, *values)

        def answer() -> list[int] | None:
            answers = self.messages("COMMAND_ACK", number)[before:]
            return [m.result for m in answers if m.command == command] or None

        return wait_for(f"command {command} is acknowledged", answer, seconds)[0]

    def texts(self) -> str:
        return "\n".join(m.text for m in self.messages("STATUSTEXT"))

    def close(self) -> None:
        self._closed = True
        self._thread.join(5)
        self.link.close()


Attach = Callable[..., GroundStation]
