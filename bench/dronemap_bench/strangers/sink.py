"""Measures the cost of the strangers' traffic alone: a port that shakes hands, reads a few kB and closes.

`python -m dronemap_bench.strangers.sink`: says its port, ends with its input.
"""

import base64
import contextlib
import hashlib
import re
import socket
import sys
import threading

from .wire import LOOPBACK

MAGIC = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
KEY = re.compile(rb"Sec-WebSocket-Key: (\S+)")
STRANGERS_BYTES = 8_192


def serve(line: socket.socket) -> None:
    with line, contextlib.suppress(OSError):
        line.settimeout(10)
        request = b""
        while b"\r\n\r\n" not in request:
            more = line.recv(4_096)
            if not more:
                return
            request += more
        found = KEY.search(request)
        if found is None:
            return
        accepted = base64.b64encode(hashlib.sha1(found[1] + MAGIC).digest())
        line.sendall(
            b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Accept: " + accepted + b"\r\n\r\n"
        )
        read = 0
        while read < STRANGERS_BYTES and (more := line.recv(STRANGERS_BYTES)):
            read += len(more)


def main() -> None:
    with socket.create_server((LOOPBACK, 0), backlog=200) as listener:
        print(listener.getsockname()[1], flush=True)
        threading.Thread(target=_accept, args=(listener,), daemon=True).start()
        sys.stdin.read()


def _accept(listener: socket.socket) -> None:
    while True:
        line, _ = listener.accept()
        threading.Thread(target=serve, args=(line,), daemon=True).start()


if __name__ == "__main__":
    main()
