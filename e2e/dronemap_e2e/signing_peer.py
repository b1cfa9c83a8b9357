"""A vehicle that signs, with pymavlink's own implementation of signing."""

import hashlib
import time
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .peer import STANDARD_HANDLERS, Handler, Peer

TICKS_PER_SECOND = 100_000
EPOCH_2015 = 1_420_070_400
MINUTE = 60 * TICKS_PER_SECOND


def now_ticks() -> int:
    return int((time.time() - EPOCH_2015) * TICKS_PER_SECOND)


class SigningPeer(Peer):
    """Takes a key as ArduPilot does."""

    def __init__(self, port: int, system_id: int, handlers: dict[str, Handler] | None = None) -> None:
        self.keys: list[bytes] = []
        super().__init__(
            port,
            system_id=system_id,
            handlers=STANDARD_HANDLERS | {"SETUP_SIGNING": apply_signing_key} | (handlers or {}),
        )

    def use_key(self, key: bytes, timestamp: int) -> None:
        """Signs from now on, and listens to nothing else; on the peer's thread."""
        self.link.signing.secret_key = key
        self.link.signing.sign_outgoing = True
        self.link.signing.timestamp = timestamp
        self.link.signing.allow_unsigned_callback = None

    def refused(self) -> int:
        """Frames of the server that pymavlink did not take for signed rightly."""
        return int(self.link.signing.badsig_count)


def apply_signing_key(peer: Peer, message: Any) -> None:
    """Applies a key as ArduPilot does: at once, a minute after the time that came along; zeros end it."""
    assert isinstance(peer, SigningPeer)
    key = bytes(message.secret_key)
    peer.keys.append(key)
    if any(key):
        peer.use_key(key, message.initial_timestamp + MINUTE)
    else:
        peer.link.signing.secret_key = None
        peer.link.signing.sign_outgoing = False


def resigned(frame: bytes, key: bytes, timestamp: int, link_id: int) -> bytes:
    """The same signed frame with another signature."""
    assert frame[0] == mavlink.PROTOCOL_MARKER_V2 and frame[2] & 1, "not a signed frame"
    body = frame[:-13] + bytes([link_id]) + timestamp.to_bytes(6, "little")
    return body + hashlib.sha256(key + body).digest()[:6]
