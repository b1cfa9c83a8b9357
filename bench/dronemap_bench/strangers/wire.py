"""WebSockets by hand (RFC 6455), as a foreign program speaks them: without a library's bounds or manners."""

import base64
import os
import socket
import struct
from collections.abc import Iterator

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
LOOPBACK = "127.0.0.1"
LARGEST_READ = 1 << 18


def connect(port: int, path: str, *headers: str, seconds: float = 10, here: str = LOOPBACK) -> socket.socket:
    """A connection from `here` that has shaken hands; ConnectionError when it was turned away."""
    line = socket.create_connection((LOOPBACK, port), timeout=seconds, source_address=(here, 0))
    try:
        line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        line.sendall(_request(port, path, headers))
        answer = b""
        while not answer.endswith(b"\r\n\r\n"):
            # One byte at a time, so that nothing of what comes behind the answer is lost.
            more = line.recv(1)
            if not more:
                raise ConnectionError("it was turned away")
            answer += more
        if not answer.startswith(b"HTTP/1.1 101"):
            raise ConnectionError(answer.partition(b"\r\n")[0].decode("ascii", "replace"))
    except BaseException:
        line.close()
        raise
    return line


def _request(port: int, path: str, headers: tuple[str, ...]) -> bytes:
    nonce = base64.b64encode(os.urandom(16)).decode()
    lines = [
        f"GET {path} HTTP/1.1",
        f"Host: {LOOPBACK}:{port}",
        "Upgrade: websocket",
        "Connection: Upgrade",
        "Sec-WebSocket-Version: 13",
        f"Sec-WebSocket-Key: {nonce}",
        *headers,
    ]
    return ("\r\n".join(lines) + "\r\n\r\n").encode("ascii")


def frame(opcode: int, payload: bytes, last: bool = True) -> bytes:
    """A frame of a client: masked, by zeros, which change nothing."""
    first = (0x80 if last else 0) | opcode
    length = len(payload)
    if length < 126:
        head = struct.pack("!BB", first, 0x80 | length)
    elif length < 1 << 16:
        head = struct.pack("!BBH", first, 0x80 | 126, length)
    else:
        head = struct.pack("!BBQ", first, 0x80 | 127, length)
    return head + bytes(4) + payload


class Reader:
    """Reads whole frames of the server from one connection; pings are answered."""

    def __init__(self, line: socket.socket) -> None:
        self.line = line
        self._held = bytearray()

    def frames(self) -> Iterator[bytes]:
        """The messages received by now; ConnectionError at the end of the connection."""
        more = self.line.recv(LARGEST_READ)
        if not more:
            raise ConnectionError("the connection ended")
        self._held += more
        while (found := self._next()) is not None:
            opcode, payload = found
            if opcode == PING:
                self.line.sendall(frame(PONG, payload))
            elif opcode == CLOSE:
                raise ConnectionError(f"closed: {payload[2:].decode('utf-8', 'replace')}")
            elif opcode in (TEXT, BINARY):
                yield payload

    def _next(self) -> tuple[int, bytes] | None:
        held = self._held
        if len(held) < 2:
            return None
        length, start = held[1] & 0x7F, 2
        if length == 126:
            if len(held) < 4:
                return None
            length, start = struct.unpack_from("!H", held, 2)[0], 4
        elif length == 127:
            if len(held) < 10:
                return None
            length, start = struct.unpack_from("!Q", held, 2)[0], 10
        if len(held) < start + length:
            return None
        found = held[0] & 0x0F, bytes(held[start : start + length])
        del held[: start + length]
        return found
