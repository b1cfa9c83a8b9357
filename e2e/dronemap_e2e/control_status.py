"""Messages that pymavlink's release does not know yet; importing this teaches them to it."""

import struct
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

CONTROL_STATUS = 512


class ControlStatus(mavlink.MAVLink_message):  # type: ignore[misc]  # pymavlink has no types
    """CONTROL_STATUS of MAVLink's development dialect: which ground station is in control."""

    id = CONTROL_STATUS
    msgname = "CONTROL_STATUS"
    fieldnames = ("flags", "gcs_main", "gcs_secondary")
    ordered_fieldnames = fieldnames
    fieldtypes = ("uint8_t", "uint8_t", "uint8_t")
    native_format = bytearray(b"<BBB")
    orders = (0, 1, 2)
    lengths = (1, 1, 10)
    array_lengths = (0, 0, 10)
    crc_extra = 21
    unpacker = struct.Struct("<BB10B")
    instance_field = None
    instance_offset = -1

    def __init__(self, flags: int, gcs_main: int, gcs_secondary: list[int]) -> None:
        super().__init__(self.id, self.msgname)
        self._fieldnames = list(self.fieldnames)
        self.flags, self.gcs_main, self.gcs_secondary = flags, gcs_main, gcs_secondary

    def pack(self, mav: Any, force_mavlink1: bool = False) -> bytes:
        payload = self.unpacker.pack(self.flags, self.gcs_main, *self.gcs_secondary)
        packed: bytes = self._pack(mav, self.crc_extra, payload, force_mavlink1=force_mavlink1)
        return packed


mavlink.mavlink_map[CONTROL_STATUS] = ControlStatus
