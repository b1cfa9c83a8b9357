"""MAVLink 2 signing with a passphrase: frames get a signature, and lose one that holds."""

import hashlib
import hmac
import time
from collections import Counter
from collections.abc import Callable

from .frames import SIGNATURE, is_signed, sender, unsigned, with_signed_flag

TICKS_PER_SECOND = 100_000
_EPOCH_2015 = 1_420_070_400
_MINUTE = 60 * TICKS_PER_SECOND
_TIMESTAMP_BYTES, _SIGNATURE_BYTES = 6, 6
_MOST_STREAMS = 4_096


def wall_ticks() -> int:
    """Since the beginning of 2015, in units of 10 µs."""
    return int((time.time() - _EPOCH_2015) * TICKS_PER_SECOND)


class Signing:
    """Signs and verifies by one passphrase: timestamps only rise, and follow those received."""

    def __init__(self, passphrase: str, link_id: int = 1, ticks: Callable[[], int] = wall_ticks) -> None:
        self._key = hashlib.sha256(passphrase.encode()).digest()
        self._link = bytes((link_id,))
        self._ticks = ticks
        self._last = 0
        self._last_of_stream: dict[tuple[int, int, int], int] = {}
        self.refused: Counter[str] = Counter()

    def __repr__(self) -> str:
        return "Signing()"

    def _signature(self, signed_part: bytes) -> bytes:
        return hashlib.sha256(self._key + signed_part).digest()[:_SIGNATURE_BYTES]

    def sign(self, frame: bytes) -> bytes:
        """A frame of version 2 with a signature of now; another's signature goes."""
        self._last = max(self._ticks(), self._last + 1)
        part = (
            with_signed_flag(unsigned(frame)) + self._link + self._last.to_bytes(_TIMESTAMP_BYTES, "little")
        )
        return part + self._signature(part)

    def verify(self, frame: bytes) -> bytes | None:
        """Without its signature; None, and counted by why, when that does not hold."""
        why = self._reason_to_refuse(frame)
        if why is not None:
            self.refused[why] += 1
            return None
        return unsigned(frame)

    def _reason_to_refuse(self, frame: bytes) -> str | None:
        if not is_signed(frame):
            return "unsigned"
        if not hmac.compare_digest(self._signature(frame[:-_SIGNATURE_BYTES]), frame[-_SIGNATURE_BYTES:]):
            return "wrong signature"
        stamp = int.from_bytes(frame[-_SIGNATURE_BYTES - _TIMESTAMP_BYTES : -_SIGNATURE_BYTES], "little")
        stream = (*sender(frame), frame[-SIGNATURE])
        last = self._last_of_stream.get(stream)
        if last is None and stamp + _MINUTE < max(self._ticks(), self._last):
            return "more than a minute old"
        if last is None and len(self._last_of_stream) >= _MOST_STREAMS:
            return "from too many senders"
        if last is not None and stamp <= last:
            return "seen before"
        self._last_of_stream[stream] = stamp
        self._last = max(self._last, stamp)
        return None
