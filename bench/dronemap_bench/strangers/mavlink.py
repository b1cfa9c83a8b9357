"""Messages of measured vehicles, in frames of MAVLink 2."""

import struct

HEARTBEAT, GLOBAL_POSITION_INT, COMMAND_ACK = 0, 33, 77
EXTRA = {HEARTBEAT: 50, GLOBAL_POSITION_INT: 104, COMMAND_ACK: 143}
HEADER, MAGIC = 10, 0xFD
# As LoadFrames of dronemap-sim: the step stands in the latitude, the vehicle in the longitude.
LATITUDE_E7, LONGITUDE_E7, VEHICLE_E7 = 470_000_000, 80_000_000, 1_000
QUAD, ARDUPILOT, ARMED_GUIDED, GUIDED, ACTIVE, VERSION = 2, 3, 0x81, 4, 4, 3


def crc(data: bytes) -> int:
    """CRC-16/MCRF4XX."""
    value = 0xFFFF
    for byte in data:
        mixed = (byte ^ value) & 0xFF
        mixed ^= (mixed << 4) & 0xFF
        value = (value >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4)
    return value


def frame(message: int, payload: bytes, sequence: int, system: int) -> bytes:
    shortened = payload.rstrip(b"\0") or b"\0"
    head = bytes([len(shortened), 0, 0, sequence & 0xFF, system, 1]) + message.to_bytes(3, "little")
    body = head + shortened
    return bytes([MAGIC]) + body + struct.pack("<H", crc(body + bytes([EXTRA[message]])))


def heartbeat(sequence: int, system: int) -> bytes:
    payload = struct.pack("<IBBBBB", GUIDED, QUAD, ARDUPILOT, ARMED_GUIDED, ACTIVE, VERSION)
    return frame(HEARTBEAT, payload, sequence, system)


def position(step: int, vehicle: int, sequence: int, system: int) -> bytes:
    place = (LATITUDE_E7 + step, LONGITUDE_E7 + vehicle * VEHICLE_E7, 500_000, 50_000)
    payload = struct.pack("<IiiiihhhH", step, *place, 100, 100, 0, 9_000)
    return frame(GLOBAL_POSITION_INT, payload, sequence, system)


def has_heartbeat(data: bytes) -> bool:
    """True if a WebSocket message has a heartbeat among its frames, of either version."""
    at = 0
    while at + 6 < len(data):
        if data[at] == MAGIC:
            message = int.from_bytes(data[at + 7 : at + 10], "little")
            at += HEADER + data[at + 1] + 2 + (13 if data[at + 2] & 1 else 0)
        elif data[at] == 0xFE:
            message = data[at + 5]
            at += 6 + data[at + 1] + 2
        else:
            return False
        if message == HEARTBEAT:
            return True
    return False
