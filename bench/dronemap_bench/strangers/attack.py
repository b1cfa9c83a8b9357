"""Strangers who each send one message in pieces that never ends, and come again whenever they are cut.

`python -m dronemap_bench.strangers.attack --port P --path /stream`: says "ready", begins when it is told to
by a line, says "sent" when the megabytes are sent or the time is over, goes on until the next line, and ends
with JSON.
"""

import argparse
import contextlib
import json
import random
import socket
import sys
import threading
import time

from . import wire

PIECE = 1_024
BLOCK_PIECES = 64
PATIENCE_SECONDS = 10


class UnauthenticatedClients:
    """Clients at one port that send endless messages; bytes count when the kernel took them."""

    def __init__(self, port: int, path: str, opcode: int, many_addresses: bool) -> None:
        """`many_addresses`: each connection comes from another one, so that no address has a history."""
        self._port = port
        self._path = path
        self._many_addresses = many_addresses
        self._first = wire.frame(opcode, b"x" * PIECE, last=False)
        self._block = wire.frame(0, b"x" * PIECE, last=False) * BLOCK_PIECES
        self._over = threading.Event()
        self._lock = threading.Lock()
        self.sent = 0
        self.connections = 0
        self.refused = 0

    def begin(self, count: int) -> None:
        for _ in range(count):
            threading.Thread(target=self._attack, daemon=True).start()

    def end(self) -> None:
        """They are daemons: who waits for an answer just now goes with this process."""
        self._over.set()

    def _attack(self) -> None:
        while not self._over.is_set():
            try:
                line = wire.connect(self._port, self._path, seconds=PATIENCE_SECONDS, here=self._address())
            except OSError:
                with self._lock:
                    self.refused += 1
                continue
            with line, contextlib.suppress(OSError):
                with self._lock:
                    self.connections += 1
                self._send(line, self._first)
                while not self._over.is_set():
                    self._send(line, self._block)

    def _address(self) -> str:
        """The whole of 127.0.0.0/8 is this machine."""
        if not self._many_addresses:
            return wire.LOOPBACK
        return f"127.{random.randrange(1, 255)}.{random.randrange(256)}.{random.randrange(1, 255)}"

    def _send(self, line: socket.socket, data: bytes) -> None:
        left = memoryview(data)
        while left:
            taken = line.send(left)
            with self._lock:
                self.sent += taken
            left = left[taken:]


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="python -m dronemap_bench.strangers.attack", description=__doc__)
    parser.add_argument("--port", type=int, required=True)
    parser.add_argument("--path", required=True)
    parser.add_argument("--opcode", type=int, default=wire.BINARY)
    parser.add_argument("--strangers", type=int, default=20)
    parser.add_argument("--megabytes", type=int, default=2_000)
    parser.add_argument("--least-seconds", type=float, default=0)
    parser.add_argument("--most-seconds", type=float, default=60)
    parser.add_argument("--many-addresses", action="store_true")
    options = parser.parse_args(arguments)
    strangers = UnauthenticatedClients(options.port, options.path, options.opcode, options.many_addresses)
    print("ready", flush=True)
    sys.stdin.readline()
    began = time.monotonic()
    strangers.begin(options.strangers)
    while (spent := time.monotonic() - began) < options.most_seconds and (
        spent < options.least_seconds or strangers.sent < options.megabytes * 1_000_000
    ):
        time.sleep(0.02)
    figures = {
        "bytes": strangers.sent,
        "connections": strangers.connections,
        "turnedAway": strangers.refused,
        "seconds": round(spent, 2),
    }
    print("sent", flush=True)
    sys.stdin.readline()
    strangers.end()
    print(json.dumps(figures), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
