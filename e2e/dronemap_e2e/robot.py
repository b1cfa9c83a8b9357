"""Robots with a ROSLink bridge, for tests: what public bridges send, and what comes of orders."""

import json
import socket
import threading
from typing import Any

Message = dict[str, Any]

HEARTBEAT, STATUS, MOTION = 0, 1, 2
TWIST = 100
STEP_SECONDS = 0.05
REPORT_STEPS = 4


class Robot:
    """One bridge with its robot, which drives on with the last speeds received, as bridges do."""

    kind = 8

    def __init__(self, udp_port: int, system_id: int, key: str | int) -> None:
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
        self._stop = threading.Event()
        self._threads = [threading.Thread(target=self._run), threading.Thread(target=self._listen_udp)]
        for thread in self._threads:
            thread.start()

    def close(self) -> None:
        self._stop.set()
        for thread in self._threads:
            thread.join()
        self._udp.close()

    def _run(self) -> None:
        step = 0
        while not self._stop.wait(STEP_SECONDS):
            self.move(STEP_SECONDS)
            if step % (5 * REPORT_STEPS) == 0:
                beat: Message = {"type": self.kind, "name": "robot", "system_status": 2, "mode": 0}
                self.send(HEARTBEAT, beat)
            if step % REPORT_STEPS == 0:
                self.report()
            step += 1

    def move(self, seconds: float) -> None:
        self.x += self.speed * seconds

    def report(self) -> None:
        """A ground robot's status has the body of a heartbeat, and its z is a yaw."""
        self.send(STATUS, {"type": self.kind, "name": "robot", "system_status": 2, "mode": 0})
        self.send(
            MOTION, {"x": self.x, "y": 0.5, "z": 0.0, "vx": self.speed, "vy": 0.0, "vz": 0.0, "wz": 0.0}
        )

    def send(self, message_id: int, body: Message) -> None:
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
                self._receive_order(json.loads(self._udp.recv(65_535)))
            except (TimeoutError, UnicodeDecodeError):
                # A vehicle of another test may have had this port, and is still being spoken to.
                continue

    def _receive_order(self, message: Message) -> None:
        header = message["header"]
        # A bridge compares what it gets with what it has, and takes the type for a part of it.
        assert header["key"] == self._key
        assert header["system_id"] == self.system_id
        self.orders.append(header["message_id"])
        self.apply_command(header["message_id"], message)

    def apply_command(self, order: int, message: Message) -> None:
        if order == TWIST:
            self.speed = sum(message[axis] for axis in ("vx", "vy", "vz", "wx", "wy", "wz"))
