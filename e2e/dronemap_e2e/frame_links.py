"""Links of every kind between a simulated vehicle and the server: each carries frames both ways."""

import os
import select
import socket
import subprocess
import threading
from pathlib import Path
from typing import Protocol

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from .dtls import DtlsClient

PATIENCE = 0.2


class FrameLink(Protocol):
    """One link; `receive` gives what the server sent, or nothing after a short wait."""

    def send(self, frame: bytes) -> None: ...

    def receive(self) -> bytes: ...

    def close(self) -> None: ...


class WebSocketLink:
    """A vehicle that opens a WebSocket to the server."""

    def __init__(self, port: int, host: str = "127.0.0.1", path: str = "/mavlink") -> None:
        self._socket = connect(f"ws://{host}:{port}{path}")

    def send(self, frame: bytes) -> None:
        self._socket.send(frame)

    def receive(self) -> bytes:
        try:
            data = self._socket.recv(timeout=PATIENCE)
        except TimeoutError:
            return b""
        assert isinstance(data, bytes), "MAVLink comes in binary messages"
        return data

    def close(self) -> None:
        self._socket.close()


class OpenSslDtlsLink:
    """OpenSSL's own client as the vehicle's end of a DTLS link."""

    def __init__(self, port: int, identity: str, secret: str, log: Path) -> None:
        with log.open("ab") as errors:
            self._process = subprocess.Popen(
                [
                    *("openssl", "s_client", "-dtls1_2", "-connect", f"127.0.0.1:{port}", "-quiet"),
                    *("-psk_identity", identity, "-psk", secret, "-cipher", "PSK-AES128-GCM-SHA256"),
                ],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                bufsize=0,
            )

    @property
    def has_ended(self) -> bool:
        return self._process.poll() is not None

    def send(self, frame: bytes) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(frame)

    def receive(self) -> bytes:
        assert self._process.stdout is not None
        ready, _, _ = select.select([self._process.stdout], [], [], PATIENCE)
        return os.read(self._process.stdout.fileno(), 4096) if ready else b""

    def close(self) -> None:
        self._process.kill()
        self._process.wait()


class DtlsLink:
    """A DTLS link with a connection id."""

    def __init__(self, port: int, identity: str, secret: str) -> None:
        self.client = DtlsClient(("127.0.0.1", port), identity, bytes.fromhex(secret))

    def send(self, frame: bytes) -> None:
        self.client.send(frame)

    def receive(self) -> bytes:
        return self.client.receive(PATIENCE)

    def close(self) -> None:
        self.client.close()


class Bridge:
    """Connects a simulated vehicle's UDP with a frame link."""

    def __init__(self, link: FrameLink) -> None:
        self.link = link
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.settimeout(PATIENCE)
        self.port: int = self._socket.getsockname()[1]
        self._vehicle: tuple[str, int] | None = None
        self._closed = False
        self._threads = [threading.Thread(target=run, daemon=True) for run in (self._up, self._down)]
        for thread in self._threads:
            thread.start()

    def _up(self) -> None:
        while not self._closed:
            try:
                frame, self._vehicle = self._socket.recvfrom(65535)
                self.link.send(frame)
            except (TimeoutError, OSError, ConnectionClosed):
                # A link may break and come back; the vehicle goes on talking.
                continue

    def _down(self) -> None:
        while not self._closed:
            try:
                data = self.link.receive()
            except (OSError, ConnectionClosed):
                continue
            if data and self._vehicle is not None:
                self._socket.sendto(data, self._vehicle)

    def close(self) -> None:
        self._closed = True
        for thread in self._threads:
            thread.join()
        self.link.close()
        self._socket.close()
