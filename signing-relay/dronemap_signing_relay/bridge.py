"""Between a tool and the server: bytes in, bytes out, no sockets."""

from pymavlink.dialects.v20 import all as dialect

from .frames import Splitter, as_version_2, sender, split_datagram
from .signing import Signing

GROUND_STATION, NO_AUTOPILOT, ACTIVE = 6, 8, 4
OWN_COMPONENT = 191
"""An on-board computer's, which no ground station has: its numbers do not mix with the tool's."""


class Bridge:
    """Signs frames of the tool, and passes to the tool what the server has signed."""

    def __init__(self, signing: Signing, system_id: int | None = None, streams: bool = False) -> None:
        """Without `system_id` signs of life are the tool's, as it calls itself.

        `streams`: from the server come bytes without bounds, as by TCP."""
        self._signing = signing
        self._system = system_id
        self._stream = Splitter() if streams else None
        self._heartbeats = 0

    def from_tool(self, datagram: bytes) -> list[bytes]:
        """Signed frames to the server."""
        frames = split_datagram(datagram)
        if frames and self._system is None:
            self._system = sender(frames[0])[0]
        return [self._signing.sign(as_version_2(frame)) for frame in frames]

    def from_server(self, data: bytes) -> list[bytes]:
        """Verified frames to the tool."""
        frames = self._stream.feed(data) if self._stream else split_datagram(data)
        return [plain for frame in frames if (plain := self._signing.verify(frame)) is not None]

    def reconnected(self) -> None:
        """Half a frame of the connection before will not go on in this one."""
        if self._stream:
            self._stream = Splitter()

    def heartbeat(self) -> bytes | None:
        """A sign of life, which attaches and keeps attached; None while nobody is there to attach."""
        if self._system is None:
            return None
        writer = dialect.MAVLink(None, srcSystem=self._system, srcComponent=OWN_COMPONENT)
        writer.seq = self._heartbeats & 0xFF
        self._heartbeats += 1
        beat = dialect.MAVLink_heartbeat_message(GROUND_STATION, NO_AUTOPILOT, 0, 0, ACTIVE, 3)
        return self._signing.sign(bytes(beat.pack(writer)))
