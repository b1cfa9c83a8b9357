"""The sockets on both sides of a bridge, on one thread."""

import logging
import selectors
import socket
import time
from collections.abc import Callable

from .addresses import Address
from .bridge import Bridge
from .signing import Signing

LOG = logging.getLogger("dronemap_signing_relay")
LARGEST = 65_535
HEARTBEAT_SECONDS = 1.0
RETRY_SECONDS = 2.0
CONNECT_SECONDS = 5.0
SILENCE_SECONDS = 10.0
TOOL_GONE_SECONDS = 5.0


class Relay:
    """One tool and one server; a tool that falls silent gives its place to the next."""

    def __init__(self, bridge: Bridge, signing: Signing, server: Address, tool: socket.socket) -> None:
        """`tool` is bound, and connected when the tool is known beforehand."""
        self._bridge = bridge
        self._signing = signing
        self._server_address = server
        self._tool = tool
        self._tool_address: tuple[object, ...] | None = None
        self._tool_received_at = 0.0
        self._selector = selectors.DefaultSelector()
        self._selector.register(tool, selectors.EVENT_READ)
        self._server: socket.socket | None = None
        self._next_try = 0.0
        self._next_heartbeat = 0.0
        self._server_received_at: float | None = None
        self._silence_reported_at = time.monotonic()

    def send_to(self, address: tuple[str, int]) -> None:
        """Sends to a tool that listens there, without waiting for its first message."""
        self._tool_address = address
        self._tool_received_at = float("inf")

    def run(self, is_running: Callable[[], bool] = lambda: True) -> None:
        """Runs until `is_running` is false, which is checked at least once a second."""
        try:
            while is_running():
                self._step()
        finally:
            self._disconnect()
            self._selector.close()

    def _step(self) -> None:
        now = time.monotonic()
        if self._server is None and now >= self._next_try:
            self._connect()
        if now >= self._next_heartbeat:
            self._next_heartbeat = now + HEARTBEAT_SECONDS
            self._send_heartbeat(now)
        for key, _ in self._selector.select(max(0.0, self._next_heartbeat - time.monotonic())):
            if key.fileobj is self._tool:
                self._read_tool()
            elif key.fileobj is self._server:
                self._read_server()

    def _connect(self) -> None:
        server = self._server_address
        kind = socket.SOCK_STREAM if server.stream else socket.SOCK_DGRAM
        try:
            family, _, _, _, address = socket.getaddrinfo(server.host, server.port, type=kind)[0]
            opened = socket.socket(family, kind)
            try:
                opened.settimeout(CONNECT_SECONDS)
                opened.connect(address)
            except OSError:
                opened.close()
                raise
        except OSError as e:
            LOG.warning("%s cannot be reached: %s", server, e)
            self._next_try = time.monotonic() + RETRY_SECONDS
            return
        self._server = opened
        self._bridge.reconnected()
        self._selector.register(opened, selectors.EVENT_READ)

    def _disconnect(self) -> None:
        if self._server is not None:
            self._selector.unregister(self._server)
            self._server.close()
            self._server = None
            self._next_try = time.monotonic() + RETRY_SECONDS

    def _send_heartbeat(self, now: float) -> None:
        beat = self._bridge.heartbeat() if self._tool_address else None
        if beat is not None:
            self._to_server(beat)
        self._warn_of_silence(now, beat is not None)

    def _warn_of_silence(self, now: float, attached: bool) -> None:
        last = max(self._server_received_at or 0.0, self._silence_reported_at)
        if not attached:
            self._silence_reported_at = now
        elif now - last > SILENCE_SECONDS:
            self._silence_reported_at = now
            why = ", ".join(f"{count} {reason}" for reason, count in self._signing.refused.items())
            LOG.warning(
                "Nothing that counts came from %s for %d s. Are passphrase and clock right? (%s)",
                self._server_address,
                SILENCE_SECONDS,
                f"not counted: {why}" if why else "nothing came at all",
            )
            self._server_received_at = None

    def _to_server(self, frame: bytes) -> None:
        if self._server is None:
            return
        try:
            self._server.sendall(frame)
        except OSError as e:
            self._server_failed(e)

    def _server_failed(self, error: OSError) -> None:
        if self._server_address.stream:
            LOG.warning("%s has hung up: %s", self._server_address, error)
            self._disconnect()
        else:
            # Nobody listens there now; the next datagram may find somebody.
            LOG.debug("%s: %s", self._server_address, error)

    def _read_tool(self) -> None:
        try:
            data, address = self._tool.recvfrom(LARGEST)
        except OSError as e:
            LOG.debug("The tool is not there: %s", e)
            return
        now = time.monotonic()
        if self._tool_address is None or address[:2] != self._tool_address[:2]:
            if self._tool_address is not None and now - self._tool_received_at < TOOL_GONE_SECONDS:
                return
            LOG.info("A tool speaks from %s:%d", *address[:2])
        self._tool_address, self._tool_received_at = address, max(now, self._tool_received_at)
        for frame in self._bridge.from_tool(data):
            self._to_server(frame)

    def _read_server(self) -> None:
        server = self._server
        if server is None:
            return
        try:
            data = server.recv(LARGEST)
            if not data and self._server_address.stream:
                raise ConnectionResetError("the connection has ended")
        except OSError as e:
            self._server_failed(e)
            return
        plain = self._bridge.from_server(data)
        if plain:
            if self._server_received_at is None:
                LOG.info("Attached to %s", self._server_address)
            self._server_received_at = time.monotonic()
        self._to_tool(plain)

    def _to_tool(self, frames: list[bytes]) -> None:
        if self._tool_address is None:
            return
        for frame in frames:
            try:
                self._tool.sendto(frame, self._tool_address)
            except OSError as e:
                LOG.debug("The tool is not there: %s", e)
                return
