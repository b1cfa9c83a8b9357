"""Records the messages of one exchange, one JSON line a message, in the order they were seen."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

# The fields kept of each message; a message that is not listed is left out.
KEPT_FIELDS: Mapping[str, tuple[str, ...]] = {
    "COMMAND_ACK": ("command", "result", "progress", "result_param2", "target_system", "target_component"),
    "COMMAND_LONG": (
        "target_system", "target_component", "command", "confirmation",
        "param1", "param2", "param3", "param4", "param5", "param6", "param7",
    ),
    "COMMAND_INT": (
        "target_system", "target_component", "frame", "command",
        "param1", "param2", "param3", "param4", "x", "y", "z",
    ),
    "SET_MODE": ("target_system", "base_mode", "custom_mode"),
    "SET_POSITION_TARGET_GLOBAL_INT": (
        "target_system", "coordinate_frame", "type_mask", "lat_int", "lon_int", "alt", "vx", "vy", "vz", "yaw",
    ),
    "PARAM_SET": ("target_system", "param_id", "param_value", "param_type"),
    "PARAM_VALUE": ("param_id", "param_value", "param_type"),
    "STATUSTEXT": ("severity", "text", "id", "chunk_seq"),
    "HEARTBEAT": ("type", "autopilot", "base_mode", "custom_mode", "system_status"),
    "EXTENDED_SYS_STATE": ("vtol_state", "landed_state"),
    "HOME_POSITION": ("latitude", "longitude", "altitude"),
    "VFR_HUD": ("groundspeed", "climb", "throttle", "heading"),
    "ATTITUDE": ("roll", "pitch", "yaw"),
    "GLOBAL_POSITION_INT": ("time_boot_ms", "lat", "lon", "relative_alt", "vx", "vy", "vz", "hdg"),
    "SYS_STATUS": (
        "onboard_control_sensors_health", "voltage_battery", "current_battery", "battery_remaining",
    ),
    "EKF_STATUS_REPORT": ("flags",),
    "FENCE_STATUS": ("breach_status", "breach_count", "breach_type"),
    "BATTERY_STATUS": ("id", "voltages", "voltages_ext", "current_battery", "current_consumed", "battery_remaining"),
    "GPS_RAW_INT": ("fix_type", "satellites_visible", "eph", "h_acc", "v_acc"),
    "AUTOPILOT_VERSION": ("capabilities", "flight_sw_version", "uid"),
    "MISSION_COUNT": ("target_system", "target_component", "count", "mission_type"),
    "MISSION_REQUEST_LIST": ("target_system", "target_component", "mission_type"),
    "MISSION_REQUEST": ("target_system", "target_component", "seq", "mission_type"),
    "RC_CHANNELS_OVERRIDE": ("target_system", "chan1_raw", "chan2_raw", "chan3_raw", "chan4_raw"),
    "MISSION_REQUEST_INT": ("target_system", "target_component", "seq", "mission_type"),
    "MISSION_ITEM_INT": (
        "target_system", "target_component", "seq", "frame", "command", "current", "autocontinue",
        "param1", "param2", "param3", "param4", "x", "y", "z", "mission_type",
    ),
    "MISSION_ITEM": ("target_system", "target_component", "seq", "frame", "command", "x", "y", "z", "mission_type"),
    "MISSION_ACK": ("target_system", "target_component", "type", "mission_type"),
    "MISSION_CURRENT": ("seq", "total", "mission_state", "mission_mode"),
    "MISSION_ITEM_REACHED": ("seq",),
    "MISSION_CLEAR_ALL": ("target_system", "target_component", "mission_type"),
    "MISSION_SET_CURRENT": ("target_system", "target_component", "seq"),
}  # fmt: skip

# Heard all the time: only what changes is written.
WRITTEN_ON_CHANGE = frozenset(
    {"HEARTBEAT", "EXTENDED_SYS_STATE", "MISSION_CURRENT", "HOME_POSITION", "EKF_STATUS_REPORT", "FENCE_STATUS"}
)

# Heard often: at most one line in so many seconds.
THINNED_SECONDS: Mapping[str, float] = {
    "VFR_HUD": 1.0,
    "GLOBAL_POSITION_INT": 1.0,
    "ATTITUDE": 1.0,
    "SYS_STATUS": 5.0,
    "GPS_RAW_INT": 5.0,
    "BATTERY_STATUS": 0.0,
}

# Of these a change is written at once.
NEVER_THINNED: Mapping[str, str] = {
    "SYS_STATUS": "onboard_control_sensors_health",
    "GPS_RAW_INT": "fix_type",
}

DECIMALS = 3
ARMED_FLAG = 128
GROUND_STATION_TYPE = 6


def plain(value: Any) -> Any:
    """A value that JSON can hold: NaN becomes null, floats lose the digits that their sensors do not have."""
    if not isinstance(value, float):
        return value
    if math.isnan(value):
        return None
    rounded = round(value, DECIMALS)
    return int(rounded) if rounded.is_integer() else rounded


class Transcript:
    """Owner: the thread that pumps the link. Silent until `start`, so that preparations stay out of the file."""

    def __init__(self, path: Path, mode_names: Mapping[int, str], clock: Callable[[], float] = time.monotonic) -> None:
        """Nothing is written before `save`; `clock` tells seconds."""
        self._clock = clock
        self._path = path
        self._mode_names = mode_names
        self._started_at: float | None = None
        self._lines: list[str] = []
        self._last: dict[str, dict[str, Any]] = {}
        self._last_at: dict[str, float] = {}
        self._parameters_set: set[str] = set()

    def start(self) -> None:
        """From now on every message that matters is kept; time 0 is now."""
        self._started_at = self._clock()

    def sent(self, message: Any) -> None:
        """One message that went to the vehicle."""
        if message.get_type() == "PARAM_SET":
            self._parameters_set.add(message.param_id)
        self._add("to", message)

    def received(self, message: Any) -> None:
        """One message that came from the vehicle."""
        kind: str = message.get_type()
        if self._started_at is None or kind not in KEPT_FIELDS or self._is_repetition(kind, message):
            return
        self._add("from", message)

    def save(self) -> None:
        """Write the file whole."""
        self._path.parent.mkdir(parents=True, exist_ok=True)
        self._path.write_text("".join(line + "\n" for line in self._lines), encoding="utf-8")

    def _is_repetition(self, kind: str, message: Any) -> bool:
        if kind == "PARAM_VALUE":
            return message.param_id not in self._parameters_set  # the autopilot tells of its own changes too
        if kind in WRITTEN_ON_CHANGE:
            fields = self._fields(kind, message)
            unchanged = self._last.get(kind) == fields
            self._last[kind] = fields
            return unchanged
        if kind in THINNED_SECONDS:
            now = self._clock()
            if self._has_changed(kind, message):
                self._last_at[kind] = now
                return False
            if now - self._last_at.get(kind, -math.inf) < THINNED_SECONDS[kind]:
                return True
            self._last_at[kind] = now
        return False

    def _has_changed(self, kind: str, message: Any) -> bool:
        field = NEVER_THINNED.get(kind)
        if field is None:
            return False
        value = {field: getattr(message, field)}
        changed = self._last.get(kind, value) != value
        self._last[kind] = value
        return changed

    def _add(self, direction: str, message: Any) -> None:
        if self._started_at is None:
            return
        kind: str = message.get_type()
        elapsed_ms = round((self._clock() - self._started_at) * 1000)
        line = {"t_ms": elapsed_ms, "dir": direction, "msg": kind, **self._fields(kind, message)}
        self._lines.append(json.dumps(line, separators=(", ", ": "), ensure_ascii=False))

    def _fields(self, kind: str, message: Any) -> dict[str, Any]:
        fields = {name: plain(getattr(message, name)) for name in KEPT_FIELDS[kind]}
        if kind == "HEARTBEAT" and fields["type"] != GROUND_STATION_TYPE:
            custom_mode = int(fields["custom_mode"])
            fields["mode"] = self._mode_names.get(custom_mode, str(custom_mode))
            fields["armed"] = bool(int(fields["base_mode"]) & ARMED_FLAG)
        return fields
