"""MAVLink frames as bytes: found in what arrives, lifted to version 2, and rid of a signature."""

from functools import cache

from pymavlink.dialects.v20 import all as dialect

MAGIC_1, MAGIC_2 = 0xFE, 0xFD
HEADER_1, HEADER_2 = 6, 10
CHECKSUM, SIGNATURE = 2, 13
SIGNED = 0x01

_SEEDS: dict[int, int] = {kind.id: kind.crc_extra for kind in dialect.mavlink_map.values()}
_START = 0xFFFF


def _crc_row(byte: int) -> int:
    for _ in range(8):
        byte = byte >> 1 ^ 0x8408 if byte & 1 else byte >> 1
    return byte


_TABLE = [_crc_row(byte) for byte in range(256)]


def checksum(data: bytes, start: int = _START) -> int:
    """CRC-16/MCRF4XX, as MAVLink has it."""
    for byte in data:
        start = start >> 8 ^ _TABLE[(start ^ byte) & 0xFF]
    return start


@cache
def _change_of_signed_flag(payload: int) -> int:
    """Change of the checksum of a frame with so long a payload by its signed flag.

    The checksum is linear: the change is the same whatever else is in the frame, so that a message that is
    not known here, whose seed nobody has, can be signed, too."""
    change = bytearray(HEADER_2 + payload)
    change[1] = SIGNED
    return checksum(bytes(change), 0)


def message_id(frame: bytes) -> int:
    return frame[5] if frame[0] == MAGIC_1 else int.from_bytes(frame[7:10], "little")


def sender(frame: bytes) -> tuple[int, int]:
    """System and component id."""
    at = 3 if frame[0] == MAGIC_1 else 5
    return frame[at], frame[at + 1]


def is_signed(frame: bytes) -> bool:
    return frame[0] == MAGIC_2 and bool(frame[2] & SIGNED)


def _length(data: bytearray, at: int) -> int | None:
    """Length of the frame that begins there; None while that is not known."""
    if len(data) - at < 3:
        return None
    if data[at] == MAGIC_1:
        return HEADER_1 + data[at + 1] + CHECKSUM
    return HEADER_2 + data[at + 1] + CHECKSUM + (SIGNATURE if data[at + 2] & SIGNED else 0)


def _is_valid(frame: bytes, is_in_step: bool) -> bool:
    """A message of version 2 that is not known here is taken as it is, but only where a frame has to begin.

    After noise a byte of chance would begin one, too, and swallow those that follow."""
    if frame[0] == MAGIC_2 and frame[2] & ~SIGNED:
        return False
    end = (HEADER_1 if frame[0] == MAGIC_1 else HEADER_2) + frame[1]
    seed = _SEEDS.get(message_id(frame))
    if seed is None:
        return frame[0] == MAGIC_2 and is_in_step
    return checksum(bytes((*frame[1:end], seed))) == int.from_bytes(frame[end : end + CHECKSUM], "little")


class Splitter:
    """Finds frames in a stream; what is none is skipped and counted in bytes."""

    def __init__(self) -> None:
        self.skipped = 0
        self._rest = bytearray()
        self._is_in_step = True

    def feed(self, data: bytes) -> list[bytes]:
        """The frames that are whole now."""
        rest = self._rest
        rest += data
        at, found = 0, []
        while at < len(rest):
            if rest[at] not in (MAGIC_1, MAGIC_2):
                self._skip()
                at += 1
                continue
            length = _length(rest, at)
            if length is None or at + length > len(rest):
                break
            frame = bytes(rest[at : at + length])
            if _is_valid(frame, self._is_in_step):
                found.append(frame)
                at += length
                self._is_in_step = True
            else:
                self._skip()
                at += 1
        del rest[:at]
        return found

    def _skip(self) -> None:
        self.skipped += 1
        self._is_in_step = False


def split_datagram(data: bytes) -> list[bytes]:
    """The frames of one datagram; no frame goes on in the next one."""
    return Splitter().feed(data)


def as_version_2(frame: bytes) -> bytes:
    """Converts a frame to version 2; its meaning stays."""
    if frame[0] == MAGIC_2:
        return frame
    payload = frame[HEADER_1:-CHECKSUM].rstrip(b"\0") or frame[HEADER_1 : HEADER_1 + 1]
    number = message_id(frame)
    body = bytes((len(payload), 0, 0, frame[2], *sender(frame), number, 0, 0)) + payload
    total = checksum(body + bytes((_SEEDS[number],)))
    return bytes((MAGIC_2,)) + body + total.to_bytes(CHECKSUM, "little")


def with_signed_flag(frame: bytes) -> bytes:
    """Says that a signature follows, and no more."""
    return _with_flipped_signed_flag(frame)


def unsigned(frame: bytes) -> bytes:
    """Without its signature, if it has one."""
    return _with_flipped_signed_flag(frame[:-SIGNATURE]) if is_signed(frame) else frame


def _with_flipped_signed_flag(frame: bytes) -> bytes:
    total = int.from_bytes(frame[-CHECKSUM:], "little") ^ _change_of_signed_flag(frame[1])
    head = frame[:2] + bytes((frame[2] ^ SIGNED,)) + frame[3:-CHECKSUM]
    return head + total.to_bytes(CHECKSUM, "little")
