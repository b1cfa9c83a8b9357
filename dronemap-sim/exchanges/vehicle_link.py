"""A MAVLink link to one vehicle, as a ground station has it: sends heartbeats, keeps the last of each message."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Any

from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from transcript import Transcript

GROUND_STATION_SYSTEM_ID = 255
GROUND_STATION_COMPONENT_ID = 190
HEARTBEAT_INTERVAL_SECONDS = 1.0
RECEIVE_TIMEOUT_SECONDS = 0.02
SLOWEST = 5  # so many seconds of this machine may one of the vehicle's take

# Message id → rate in Hz that the recording needs (an autopilot sends little unasked).
WANTED_RATES_HZ: Mapping[int, float] = {
    mavlink.MAVLINK_MSG_ID_SYS_STATUS: 2,
    mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT: 10,
    mavlink.MAVLINK_MSG_ID_VFR_HUD: 10,
    mavlink.MAVLINK_MSG_ID_EXTENDED_SYS_STATE: 10,
    mavlink.MAVLINK_MSG_ID_MISSION_CURRENT: 5,
    mavlink.MAVLINK_MSG_ID_EKF_STATUS_REPORT: 2,
    mavlink.MAVLINK_MSG_ID_SYSTEM_TIME: 20,
}


class ExchangeError(Exception):
    """A message or state that an exchange waited for did not come."""


class VehicleLink:
    """Owner: the one thread that runs the exchange. All sending and waiting pumps the socket; nothing else does."""

    def __init__(self, address: str, mode_names: Mapping[int, str]) -> None:
        """`address` is a pymavlink connection string such as udpin:127.0.0.1:15700."""
        self._connection = mavutil.mavlink_connection(
            address,
            source_system=GROUND_STATION_SYSTEM_ID,
            source_component=GROUND_STATION_COMPONENT_ID,
            dialect="ardupilotmega",
        )
        self._mode_numbers = {name: number for number, name in mode_names.items()}
        self._mode_names = mode_names
        self._heartbeat_at = 0.0
        self._inbox: list[Any] = []
        self.heartbeats_on = True
        self.transcript: Transcript | None = None
        self.log_heartbeats = False
        self.system_id = 0
        self._clock_ahead: float | None = None
        self._booted_seconds = 0.0
        self.last: dict[str, Any] = {}
        self.counts: dict[str, int] = {}

    def close(self) -> None:
        """Give the socket back."""
        self._connection.close()

    def clock(self) -> float:
        """Seconds by the vehicle's own clock: in simulation a busy machine makes it go slower than this one's.

        Until the vehicle has told its time, this machine's.
        """
        return time.monotonic() if self._clock_ahead is None else self._booted_seconds + self._clock_ahead

    # --- sending -------------------------------------------------------------------------------------------

    def send(self, message: Any) -> None:
        """One message to the vehicle, kept in the transcript."""
        self._connection.mav.send(message)
        if self.transcript is not None:
            self.transcript.sent(message)

    def command_long(self, command: int, *params: float, confirmation: int = 0, component: int = 1) -> None:
        """COMMAND_LONG; parameters left out are 0."""
        padded = [*params, *([0.0] * (7 - len(params)))]
        self.send(mavlink.MAVLink_command_long_message(self.system_id, component, command, confirmation, *padded))

    def command_int(self, command: int, frame: int, params: tuple[float, ...], position: Any) -> None:
        """COMMAND_INT with `position` = (x, y, z): degrees × 10⁷ and metres."""
        self.send(mavlink.MAVLink_command_int_message(self.system_id, 1, frame, command, 0, 0, *params, *position))

    def set_mode(self, name: str) -> None:
        """DO_SET_MODE by ArduCopter's own name of the mode."""
        self.command_long(
            mavlink.MAV_CMD_DO_SET_MODE,
            mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED,
            self._mode_numbers[name],
        )

    def set_parameter(self, name: str, value: float) -> None:
        """PARAM_SET, then wait for its echo."""
        self._inbox.clear()
        self.send(
            mavlink.MAVLink_param_set_message(self.system_id, 1, name.encode(), value, mavlink.MAV_PARAM_TYPE_REAL32)
        )
        self.expect(f"PARAM_VALUE {name}", lambda m: m.get_type() == "PARAM_VALUE" and m.param_id == name, 5)

    def request_rates(self) -> None:
        """Ask for the messages that the recording needs."""
        for message_id, rate_hz in WANTED_RATES_HZ.items():
            self.command_long(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, message_id, 1e6 / rate_hz)
            self.wait_for_acknowledgement(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL)

    # --- hearing -------------------------------------------------------------------------------------------

    def pump(self) -> list[Any]:
        """Send a heartbeat if one is due, wait a moment, return what was received."""
        self._send_heartbeat()
        received = []
        message = self._connection.recv_match(blocking=True, timeout=RECEIVE_TIMEOUT_SECONDS)
        while message is not None:
            if message.get_type() != "BAD_DATA":
                self._receive(message)
                received.append(message)
            message = self._connection.recv_match(blocking=False)
        return received

    def pump_for(self, seconds: float) -> None:
        """Only watch for so long."""
        deadline = self.clock() + seconds
        given_up_at = time.monotonic() + seconds * SLOWEST
        while self.clock() < deadline:
            if time.monotonic() > given_up_at:
                raise ExchangeError("the vehicle's clock stands still")
            self.pump()

    def wait_until(self, what: str, condition: Callable[[], bool], seconds: float) -> None:
        """Pump until the state is so."""
        deadline = time.monotonic() + seconds * SLOWEST
        while not condition():
            if time.monotonic() > deadline:
                raise ExchangeError(f"waited {seconds} s in vain: {what}")
            self.pump()

    def expect(self, what: str, wanted: Callable[[Any], bool], seconds: float) -> Any:
        """The first wanted message received since the last call; earlier ones are passed over."""
        deadline = time.monotonic() + seconds * SLOWEST
        while True:
            while self._inbox:
                message = self._inbox.pop(0)
                if wanted(message):
                    return message
            if time.monotonic() > deadline:
                raise ExchangeError(f"waited {seconds} s in vain: {what}")
            self.pump()

    def wait_for_acknowledgement(self, command: int, seconds: float = 5) -> int:
        """The result of the next COMMAND_ACK of this command."""
        ack = self.expect(
            f"COMMAND_ACK of {command}",
            lambda m: m.get_type() == "COMMAND_ACK" and m.command == command,
            seconds,
        )
        return int(ack.result)

    def send_and_acknowledge(self, command: int, *params: float) -> int:
        """COMMAND_LONG and its result."""
        self._inbox.clear()
        self.command_long(command, *params)
        return self.wait_for_acknowledgement(command)

    def set_mode_and_acknowledge(self, name: str) -> int:
        """DO_SET_MODE and its result."""
        self._inbox.clear()
        self.set_mode(name)
        return self.wait_for_acknowledgement(mavlink.MAV_CMD_DO_SET_MODE)

    def clear_inbox(self) -> None:
        """`expect` will look only at what is received from now on."""
        self._inbox.clear()

    # --- what is known -------------------------------------------------------------------------------------

    @property
    def armed(self) -> bool:
        """From the last HEARTBEAT."""
        return bool(self.last["HEARTBEAT"].base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED)

    @property
    def mode(self) -> str:
        """From the last HEARTBEAT."""
        number = self.last["HEARTBEAT"].custom_mode
        return self._mode_names.get(number, str(number))

    @property
    def altitude_meters(self) -> float:
        """Above home."""
        return float(self.last["GLOBAL_POSITION_INT"].relative_alt) / 1000

    @property
    def position(self) -> tuple[int, int]:
        """Latitude and longitude in degrees × 10⁷."""
        here = self.last["GLOBAL_POSITION_INT"]
        return int(here.lat), int(here.lon)

    @property
    def landed_state(self) -> int:
        """MAV_LANDED_STATE from the last EXTENDED_SYS_STATE."""
        return int(self.last["EXTENDED_SYS_STATE"].landed_state)

    @property
    def ready(self) -> bool:
        """True when the autopilot says that it would arm, and its estimator, if it reports one, has a position."""
        status = self.last.get("SYS_STATUS")
        if status is None or "GLOBAL_POSITION_INT" not in self.last:
            return False
        checked = bool(status.onboard_control_sensors_health & mavlink.MAV_SYS_STATUS_PREARM_CHECK)
        estimate = self.last.get("EKF_STATUS_REPORT")
        if estimate is None:
            return checked
        positioned = bool(estimate.flags & mavlink.EKF_POS_HORIZ_ABS)
        return checked and positioned and not estimate.flags & mavlink.EKF_CONST_POS_MODE

    # --- inside --------------------------------------------------------------------------------------------

    def _send_heartbeat(self) -> None:
        now = time.monotonic()
        if not self.heartbeats_on or now - self._heartbeat_at < HEARTBEAT_INTERVAL_SECONDS:
            return
        self._heartbeat_at = now
        beat = mavlink.MAVLink_heartbeat_message(
            mavlink.MAV_TYPE_GCS, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, mavlink.MAV_STATE_ACTIVE, 3
        )
        self._connection.mav.send(beat)
        if self.transcript is not None and self.log_heartbeats:
            self.transcript.sent(beat)

    def _receive(self, message: Any) -> None:
        kind: str = message.get_type()
        if kind == "HEARTBEAT" and not self.system_id:
            self.system_id = message.get_srcSystem()
        if kind == "SYSTEM_TIME":
            self._booted_seconds = max(self._booted_seconds, message.time_boot_ms / 1000)
            if self._clock_ahead is None:
                self._clock_ahead = time.monotonic() - self._booted_seconds
        self.last[kind] = message
        self.counts[kind] = self.counts.get(kind, 0) + 1
        self._inbox.append(message)
        if self.transcript is not None:
            self.transcript.received(message)
