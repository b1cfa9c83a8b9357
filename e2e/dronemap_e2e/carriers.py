"""Links of every kind between a simulated vehicle and the server: each carries frames both ways."""

import os
import queue
import select
import socket
import subprocess
import threading
import tty
from pathlib import Path
from typing import Protocol

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect
from websockets.sync.server import Server, ServerConnection, serve

from .dtls import DtlsClient

PATIENCE = 0.2


class Carrier(Protocol):
    """One link; `receive` gives what the server sent, or nothing after a short wait."""

    def send(self, frame: bytes) -> None: ...

    def receive(self) -> bytes: ...

    def close(self) -> None: ...


class SerialCable:
    """A pseudo-terminal: the server opens `device` as if it were a radio."""

    def __init__(self) -> None:
        self._end, self._other = os.openpty()
        tty.setraw(self._end)
        tty.setraw(self._other)
        self.device = os.ttyname(self._other)

    def send(self, frame: bytes) -> None:
        os.write(self._end, frame)

    def receive(self) -> bytes:
        ready, _, _ = select.select([self._end], [], [], PATIENCE)
        return os.read(self._end, 4096) if ready else b""

    def close(self) -> None:
        os.close(self._other)
        os.close(self._end)


class UdpListener:
    """A vehicle that only answers: it knows the server from the first datagram on."""

    def __init__(self) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.settimeout(PATIENCE)
        self.port: int = self._socket.getsockname()[1]
        self._server: tuple[str, int] | None = None

    def send(self, frame: bytes) -> None:
        if self._server is not None:
            self._socket.sendto(frame, self._server)

    def receive(self) -> bytes:
        try:
            data, self._server = self._socket.recvfrom(65535)
        except TimeoutError:
            return b""
        return data

    def close(self) -> None:
        self._socket.close()


class UdpCaller:
    """A vehicle that sends to one address, from a port of its own."""

    def __init__(self, port: int) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(("127.0.0.1", port))
        self._socket.settimeout(PATIENCE)
        self.port: int = self._socket.getsockname()[1]

    def send(self, frame: bytes) -> None:
        self._socket.send(frame)

    def receive(self) -> bytes:
        try:
            return self._socket.recv(65535)
        except (TimeoutError, ConnectionError):
            return b""

    def close(self) -> None:
        self._socket.close()


class Together:
    """Several links of one vehicle: each frame goes over all of them, and answers come over any."""

    def __init__(self, *carriers: Carrier) -> None:
        self._carriers = list(carriers)
        self._down: queue.Queue[bytes] = queue.Queue()
        self._closed = False
        self._threads = [threading.Thread(target=self._hear, args=(c,), daemon=True) for c in carriers]
        for thread in self._threads:
            thread.start()

    def _hear(self, carrier: Carrier) -> None:
        while not self._closed:
            data = carrier.receive()
            if data:
                self._down.put(data)

    def send(self, frame: bytes) -> None:
        for carrier in self._carriers:
            carrier.send(frame)

    def receive(self) -> bytes:
        try:
            return self._down.get(timeout=PATIENCE)
        except queue.Empty:
            return b""

    def close(self) -> None:
        self._closed = True
        for thread in self._threads:
            thread.join()
        for carrier in self._carriers:
            carrier.close()


class TcpListener:
    """A modem that listens; it takes one connection after the other."""

    def __init__(self) -> None:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._listener.settimeout(PATIENCE)
        self.port: int = self._listener.getsockname()[1]
        self._connection: socket.socket | None = None

    def send(self, frame: bytes) -> None:
        if self._connection is not None:
            self._connection.sendall(frame)

    def receive(self) -> bytes:
        try:
            if self._connection is None:
                self._connection, _ = self._listener.accept()
                self._connection.settimeout(PATIENCE)
            data = self._connection.recv(4096)
        except TimeoutError:
            return b""
        if not data:
            self._connection = None
        return data

    def hang_up(self) -> None:
        """Closes the connection; the listener takes the next one."""
        assert self._connection is not None
        self._connection.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        if self._connection is not None:
            self._connection.close()
        self._listener.close()


class WebSocketCaller:
    """A vehicle that opens a WebSocket to the server."""

    def __init__(self, port: int) -> None:
        self._socket = connect(f"ws://127.0.0.1:{port}/mavlink")

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


class WebSocketListener:
    """A vehicle whose WebSocket the server opens."""

    def __init__(self) -> None:
        self._down: queue.Queue[bytes] = queue.Queue()
        self._connection: ServerConnection | None = None
        self._server: Server = serve(self._serve, "127.0.0.1", 0)
        self.port: int = self._server.socket.getsockname()[1]
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def _serve(self, connection: ServerConnection) -> None:
        self._connection = connection
        for data in connection:
            assert isinstance(data, bytes), "MAVLink comes in binary messages"
            self._down.put(data)

    def send(self, frame: bytes) -> None:
        if self._connection is not None:
            self._connection.send(frame)

    def receive(self) -> bytes:
        try:
            return self._down.get(timeout=PATIENCE)
        except queue.Empty:
            return b""

    def close(self) -> None:
        self._server.shutdown()


class OpenSsl:
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


class Dtls:
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
    """A simulated vehicle's UDP on one side, a carrier on the other."""

    def __init__(self, carrier: Carrier) -> None:
        self.carrier = carrier
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
                self.carrier.send(frame)
            except (TimeoutError, OSError, ConnectionClosed):
                # A link may break and come back; the vehicle goes on talking.
                continue

    def _down(self) -> None:
        while not self._closed:
            try:
                data = self.carrier.receive()
            except (OSError, ConnectionClosed):
                continue
            if data and self._vehicle is not None:
                self._socket.sendto(data, self._vehicle)

    def close(self) -> None:
        self._closed = True
        for thread in self._threads:
            thread.join()
        self.carrier.close()
        self._socket.close()
