"""Robots with a ROSLink bridge, for tests: what public bridges send, and what comes of orders."""

import json
import math
import socket
import threading
from typing import Any

from websockets.sync.client import ClientConnection, connect

Message = dict[str, Any]

HEARTBEAT, STATUS, MOTION = 0, 1, 2
TWIST, TAKE_OFF, LAND, ARM, DISARM, SET_MODE = 100, 102, 103, 104, 105, 106
TICK_SECONDS = 0.05
REPORT_TICKS = 4
STANDBY, ACTIVE = 3, 4
CLIMB = 3.0


class Robot:
    """One bridge with the truth of its robot; drives on with the last speeds that it heard, as bridges do."""

    kind = 8

    def __init__(self, udp_port: int, system_id: int, key: str | int, web_address: str | None = None) -> None:
        self.system_id = system_id
        self.orders: list[int] = []
        self.x = 0.0
        self.speed = 0.0
        self._key = key
        self._sequence = 0
        self._server = ("127.0.0.1", udp_port)
        self._udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._udp.settimeout(0.2)
        self._udp.bind(("127.0.0.1", 0))
        self._web: ClientConnection | None = connect(web_address) if web_address else None
        self._stop = threading.Event()
        self._threads = [threading.Thread(target=self._live), threading.Thread(target=self._listen_udp)]
        if self._web:
            self._threads.append(threading.Thread(target=self._listen_web))
        for thread in self._threads:
            thread.start()

    def close(self) -> None:
        self._stop.set()
        if self._web:
            self._web.close()
        for thread in self._threads:
            thread.join()
        self._udp.close()

    def _live(self) -> None:
        tick = 0
        while not self._stop.wait(TICK_SECONDS):
            self.move(TICK_SECONDS)
            if tick % (5 * REPORT_TICKS) == 0:
                beat: Message = {"type": self.kind, "name": "robot", "system_status": 2, "mode": 0}
                self._say(HEARTBEAT, beat)
                if self._web:
                    self._say_udp(HEARTBEAT, beat)
            if tick % REPORT_TICKS == 0:
                self.report()
            tick += 1

    def move(self, seconds: float) -> None:
        self.x += self.speed * seconds

    def report(self) -> None:
        """A ground robot's status has the body of a heartbeat, and its z is a yaw."""
        self.say(STATUS, {"type": self.kind, "name": "robot", "system_status": 2, "mode": 0})
        self.say(MOTION, {"x": self.x, "y": 0.5, "z": 0.0, "vx": self.speed, "vy": 0.0, "vz": 0.0, "wz": 0.0})

    def say(self, message_id: int, body: Message) -> None:
        self._say(message_id, body)

    def _say(self, message_id: int, body: Message) -> None:
        if self._web:
            self._web.send(self._text(message_id, body))
        else:
            self._say_udp(message_id, body)

    def _say_udp(self, message_id: int, body: Message) -> None:
        self._udp.sendto(self._text(message_id, body).encode(), self._server)

    def _text(self, message_id: int, body: Message) -> str:
        self._sequence += 1
        header = {
            "roslink_version": 1,
            "ros_version": 8,
            "system_id": self.system_id,
            "message_id": message_id,
            "sequence_number": self._sequence,
            "key": self._key,
        }
        return json.dumps({"header": header, **body})

    def _listen_udp(self) -> None:
        while not self._stop.is_set():
            try:
                self._heard(json.loads(self._udp.recv(65_535)))
            except (TimeoutError, UnicodeDecodeError):
                # A vehicle of another test may have had this port, and is still being spoken to.
                continue

    def _listen_web(self) -> None:
        assert self._web
        for text in self._web:
            self._heard(json.loads(text))

    def _heard(self, message: Message) -> None:
        header = message["header"]
        # A bridge compares what it gets with what it has, and takes the type for a part of it.
        assert header["key"] == self._key
        assert header["system_id"] == self.system_id
        self.orders.append(header["message_id"])
        self.obey(header["message_id"], message)

    def obey(self, order: int, message: Message) -> None:
        if order == TWIST:
            self.speed = sum(message[axis] for axis in ("vx", "vy", "vz", "wx", "wy", "wz"))


class FlyingRobot(Robot):
    """A drone behind mavros: its state says how it stands, whether it is armed, and its mode."""

    kind = 3

    def __init__(self, udp_port: int, system_id: int, key: str | int, obedient: bool = True) -> None:
        self.obedient = obedient
        self.armed = False
        self.mode = 0
        self.height = 0.0
        self.wanted = 0.0
        super().__init__(udp_port, system_id, key)

    def move(self, seconds: float) -> None:
        way = self.wanted - self.height
        self.height += math.copysign(min(abs(way), CLIMB * seconds), way)

    def report(self) -> None:
        system = ACTIVE if self.height > 0 else STANDBY
        self.say(STATUS, {"state": 1000 * system + 100 * self.armed + self.mode, "voltage_battery": 12.1})
        self.say(MOTION, {"x": 0.0, "y": 0.0, "z": self.height, "vx": 0.0, "vy": 0.0, "vz": 0.0})

    def obey(self, order: int, message: Message) -> None:
        if not self.obedient:
            return
        if order == ARM:
            self.armed = True
        elif order == DISARM:
            self.armed = False
        elif order == SET_MODE:
            self.mode = message["flightMode"]
        elif order == TAKE_OFF and self.armed and self.mode == 4:
            self.wanted = float(message["altitude"])
        elif order == LAND:
            self.wanted = 0.0
