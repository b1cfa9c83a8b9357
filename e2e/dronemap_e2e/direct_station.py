"""A ground station plugged straight into a vehicle behind an impairer: it sees what is really held."""

import queue
import time
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .impairer import Impairer

SYSTEM = 254
PATIENCE = 2.0
TRIES = 20


class DirectStation:
    """Asks with pymavlink, past the bad link and past the server."""

    def __init__(self, link: Impairer, system_id: int) -> None:
        self._link = link
        self._vehicle = system_id
        self._mavlink: Any = mavlink.MAVLink(self, srcSystem=SYSTEM, srcComponent=190)
        self._parser: Any = mavlink.MAVLink(None)
        self._parser.robust_parsing = True
        self._received: queue.Queue[Any] = queue.Queue()
        link.on_datagram = self._on_datagram

    def write(self, data: bytes) -> None:
        """pymavlink sends through this."""
        self._link.send_to_vehicles(data)

    def parameters(self) -> dict[str, tuple[float, int]]:
        """Name to value and type, as the vehicle sends them: bits stay bits."""
        self._forget()
        found: dict[int, tuple[str, float, int]] = {}
        count = -1
        self._mavlink.param_request_list_send(self._vehicle, 1)
        for _ in range(TRIES):
            while (received := self._next("PARAM_VALUE")) is not None:
                if received.param_index < received.param_count:
                    count = received.param_count
                    found[received.param_index] = (
                        received.param_id,
                        received.param_value,
                        received.param_type,
                    )
                if len(found) == count:
                    return {name: (value, kind) for name, value, kind in found.values()}
            for index in set(range(max(0, count))) - set(found):
                self._mavlink.param_request_read_send(self._vehicle, 1, b"", index)
        raise AssertionError(f"the vehicle told {len(found)} of {count} parameters")

    def mission(self, kind: int = 0) -> list[Any]:
        """The items of one kind of mission."""
        count = self._ask(
            lambda: self._mavlink.mission_request_list_send(self._vehicle, 1, kind),
            lambda m: m.get_type() == "MISSION_COUNT" and m.mission_type == kind,
        ).count
        return [self._item(seq, kind) for seq in range(count)]

    def home(self) -> tuple[int, int, int]:
        """Latitude and longitude in degrees times 1e7, altitude in millimetres above sea level."""
        home = self._ask(
            lambda: self._mavlink.command_long_send(
                self._vehicle, 1, mavlink.MAV_CMD_REQUEST_MESSAGE, 0, 242, 0, 0, 0, 0, 0, 0
            ),
            lambda m: m.get_type() == "HOME_POSITION",
            addressed=False,
        )
        return home.latitude, home.longitude, home.altitude

    def _item(self, seq: int, kind: int) -> Any:
        return self._ask(
            lambda: self._mavlink.mission_request_int_send(self._vehicle, 1, seq, kind),
            lambda m: m.get_type() == "MISSION_ITEM_INT" and m.seq == seq and m.mission_type == kind,
        )

    def _ask(self, question: Any, is_answer: Any, addressed: bool = True) -> Any:
        self._forget()
        for _ in range(TRIES):
            question()
            until = time.monotonic() + PATIENCE
            while time.monotonic() < until:
                received = self._next()
                if received is None or not is_answer(received):
                    continue
                if not addressed or received.target_system in (0, SYSTEM):
                    return received
        raise AssertionError("the vehicle does not answer the station that is plugged into it")

    def _forget(self) -> None:
        """Drops what was received before the question."""
        while not self._received.empty():
            self._received.get_nowait()

    def _next(self, kind: str | None = None) -> Any | None:
        until = time.monotonic() + PATIENCE
        while (left := until - time.monotonic()) > 0:
            try:
                message = self._received.get(timeout=left)
            except queue.Empty:
                return None
            if kind is None or message.get_type() == kind:
                return message
        return None

    def _on_datagram(self, data: bytes) -> None:
        for message in self._parser.parse_buffer(data) or []:
            if message.get_srcSystem() == self._vehicle:
                self._received.put(message)
