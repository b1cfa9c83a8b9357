"""Maps as PNG pictures, with nothing but the standard library."""

import struct
import zlib

from .robot import Map

UNKNOWN, FREE, OCCUPIED = 205, 254, 0
OCCUPIED_FROM = 65


def png(area: Map) -> bytes:
    """Grey, seen from above: the upper edge is the largest y."""
    lines = bytearray()
    for row in range(area.rows - 1, -1, -1):
        lines.append(0)
        cells = area.cells[row * area.columns : (row + 1) * area.columns]
        lines += bytes(UNKNOWN if cell < 0 else OCCUPIED if cell >= OCCUPIED_FROM else FREE for cell in cells)
    head = struct.pack(">IIBBBBB", area.columns, area.rows, 8, 0, 0, 0, 0)
    parts = (_part(b"IHDR", head), _part(b"IDAT", zlib.compress(bytes(lines))), _part(b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def _part(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
