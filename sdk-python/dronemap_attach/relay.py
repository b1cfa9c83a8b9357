"""The sockets on both sides of a bridge, on one thread."""

import logging
import selectors
import socket
import time
from collections.abc import Callable

from .bridge import Bridge
from .places import Place
from .signing import Signing

LOG = logging.getLogger("dronemap_attach")
LARGEST = 65_535
BEAT_SECONDS = 1.0
RETRY_SECONDS = 2.0
CONNECT_SECONDS = 5.0
SILENCE_SECONDS = 10.0
TOOL_GONE_SECONDS = 5.0


class Relay:
    """One tool and one server; a tool that falls silent gives its place to the next."""

    def __init__(self, bridge: Bridge, signing: Signing, server: Place, tool: socket.socket) -> None:
        """`tool` is bound, and connected when the tool is known beforehand."""
        self._bridge = bridge
        self._signing = signing
        self._server_place = server
        self._tool = tool
        self._tool_address: tuple[object, ...] | None = None
        self._tool_heard = 0.0
        self._selector = selectors.DefaultSelector()
        self._selector.register(tool, selectors.EVENT_READ)
        self._server: socket.socket | None = None
        self._next_try = 0.0
        self._next_beat = 0.0
        self._server_heard: float | None = None
        self._silence_told = time.monotonic()

    def send_to(self, address: tuple[str, int]) -> None:
        """The tool listens there and need not speak first."""
        self._tool_address = address
        self._tool_heard = float("inf")

    def run(self, goes_on: Callable[[], bool] = lambda: True) -> None:
        """Until `goes_on` says no, which is asked at least once a second."""
        try:
            while goes_on():
                self._turn()
        finally:
            self._drop_server()
            self._selector.close()

    def _turn(self) -> None:
        now = time.monotonic()
        if self._server is None and now >= self._next_try:
            self._connect()
        if now >= self._next_beat:
            self._next_beat = now + BEAT_SECONDS
            self._beat(now)
        for key, _ in self._selector.select(max(0.0, self._next_beat - time.monotonic())):
            if key.fileobj is self._tool:
                self._read_tool()
            elif key.fileobj is self._server:
                self._read_server()

    def _connect(self) -> None:
        place = self._server_place
        kind = socket.SOCK_STREAM if place.stream else socket.SOCK_DGRAM
        try:
            family, _, _, _, address = socket.getaddrinfo(place.host, place.port, type=kind)[0]
            made = socket.socket(family, kind)
            try:
                made.settimeout(CONNECT_SECONDS)
                made.connect(address)
            except OSError:
                made.close()
                raise
        except OSError as e:
            LOG.warning("%s cannot be reached: %s", place, e)
            self._next_try = time.monotonic() + RETRY_SECONDS
            return
        self._server = made
        self._bridge.reconnected()
        self._selector.register(made, selectors.EVENT_READ)

    def _drop_server(self) -> None:
        if self._server is not None:
            self._selector.unregister(self._server)
            self._server.close()
            self._server = None
            self._next_try = time.monotonic() + RETRY_SECONDS

    def _beat(self, now: float) -> None:
        beat = self._bridge.beat() if self._tool_address else None
        if beat is not None:
            self._to_server(beat)
        self._tell_silence(now, beat is not None)

    def _tell_silence(self, now: float, attached: bool) -> None:
        last = max(self._server_heard or 0.0, self._silence_told)
        if not attached:
            self._silence_told = now
        elif now - last > SILENCE_SECONDS:
            self._silence_told = now
            why = ", ".join(f"{count} {reason}" for reason, count in self._signing.refused.items())
            LOG.warning(
                "Nothing that counts came from %s for %d s. Are passphrase and clock right? (%s)",
                self._server_place,
                SILENCE_SECONDS,
                f"not counted: {why}" if why else "nothing came at all",
            )
            self._server_heard = None

    def _to_server(self, frame: bytes) -> None:
        if self._server is None:
            return
        try:
            self._server.sendall(frame)
        except OSError as e:
            self._server_failed(e)

    def _server_failed(self, error: OSError) -> None:
        if self._server_place.stream:
            LOG.warning("%s has hung up: %s", self._server_place, error)
            self._drop_server()
        else:
            # Nobody listens there now; the next datagram may find somebody.
            LOG.debug("%s: %s", self._server_place, error)

    def _read_tool(self) -> None:
        try:
            data, address = self._tool.recvfrom(LARGEST)
        except OSError as e:
            LOG.debug("The tool is not there: %s", e)
            return
        now = time.monotonic()
        if self._tool_address is None or address[:2] != self._tool_address[:2]:
            if self._tool_address is not None and now - self._tool_heard < TOOL_GONE_SECONDS:
                return
            LOG.info("A tool speaks from %s:%d", *address[:2])
        self._tool_address, self._tool_heard = address, max(now, self._tool_heard)
        for frame in self._bridge.from_tool(data):
            self._to_server(frame)

    def _read_server(self) -> None:
        server = self._server
        if server is None:
            return
        try:
            data = server.recv(LARGEST)
            if not data and self._server_place.stream:
                raise ConnectionResetError("the connection has ended")
        except OSError as e:
            self._server_failed(e)
            return
        plain = self._bridge.from_server(data)
        if plain:
            if self._server_heard is None:
                LOG.info("Attached to %s", self._server_place)
            self._server_heard = time.monotonic()
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
