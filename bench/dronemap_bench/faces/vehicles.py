"""Vehicles that carry out each order at once: what a command takes beyond them is the server's own."""

import selectors
import socket
import struct
import threading
import time

from ..strangers import mavlink

COMMAND_LONG = 76
SET_RELAY = 181
ACCEPTED, UNSUPPORTED = 0, 3
COMMAND_AT, HEADER, PAYLOAD = 28, 10, 33
HEARTBEAT_SECONDS = 1.0
SYSTEM = 77


class AcknowledgingVehicles:
    """Vehicles that send heartbeats, each from its own port, and acknowledge commands at once. One thread."""

    def __init__(self, port: int, count: int) -> None:
        self._waiting = selectors.DefaultSelector()
        self._sockets = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(count)]
        for one in self._sockets:
            one.bind(("127.0.0.1", 0))
            one.connect(("127.0.0.1", port))
            self._waiting.register(one, selectors.EVENT_READ, one)
        self.ports: list[int] = [one.getsockname()[1] for one in self._sockets]
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def stop(self) -> None:
        self._over.set()
        self._thread.join()
        self._waiting.close()
        for one in self._sockets:
            one.close()

    def _run(self) -> None:
        sequence, beat = 0, 0.0
        while not self._over.is_set():
            sequence += 1
            if time.monotonic() - beat >= HEARTBEAT_SECONDS:
                beat = time.monotonic()
                for one in self._sockets:
                    one.send(mavlink.heartbeat(sequence, SYSTEM))
            for key, _ in self._waiting.select(0.1):
                data = key.data.recv(2048)
                if data[0] == mavlink.MAGIC and int.from_bytes(data[7:10], "little") == COMMAND_LONG:
                    key.data.send(_acknowledgement(data, sequence))


def _acknowledgement(data: bytes, sequence: int) -> bytes:
    # Zeros at the end of a payload are not sent.
    payload = data[HEADER : HEADER + data[1]].ljust(PAYLOAD, b"\0")
    (command,) = struct.unpack_from("<H", payload, COMMAND_AT)
    result = ACCEPTED if command == SET_RELAY else UNSUPPORTED
    answer = struct.pack("<HBBiBB", command, result, 0, 0, data[5], data[6])
    return mavlink.frame(mavlink.COMMAND_ACK, answer, sequence, SYSTEM)
