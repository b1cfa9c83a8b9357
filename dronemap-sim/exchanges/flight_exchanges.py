"""Exchanges in flight with nothing broken."""

from __future__ import annotations

import math
import time

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import (
    DEGREES_E7_PER_METER_NORTH,
    GLOBAL_RELATIVE,
    UNCHANGED,
    airborne,
    arm,
    arrived,
    climb_to,
    disarmed,
    go_to,
    north_of_here,
    ready,
    send_moving_setpoint,
    start,
    take_off,
)
from vehicle_link import VehicleLink

LED_SECONDS = 15
LED_NORTH = 5.0


def guided_takeoff(link: VehicleLink) -> None:
    """GUIDED, arm, take-off to 20 m, hover, land by command, disarmed by itself."""
    ready(link)
    start(link)
    climb_to(link, 20)
    link.pump_for(8)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
    disarmed(link)


def go_to_by_setpoint(link: VehicleLink) -> None:
    """150 m north at the same height by one SET_POSITION_TARGET_GLOBAL_INT; then one in LOITER, which is ignored."""
    airborne(link)
    start(link)
    target = north_of_here(link, 150)
    go_to(link, target, 20)
    arrived(link, target)
    link.pump_for(2)
    link.set_mode_and_acknowledge("LOITER")
    go_to(link, north_of_here(link, -50), 20)
    link.pump_for(6)


def follow_moving_setpoint(link: VehicleLink) -> None:
    """Ten setpoints a second that move north at 5 m/s and look east; after 15 s none any more."""
    airborne(link)
    latitude, longitude = link.position
    start(link)
    began = time.monotonic()
    while (seconds := time.monotonic() - began) < LED_SECONDS:
        moved = round(LED_NORTH * seconds * DEGREES_E7_PER_METER_NORTH)
        send_moving_setpoint(link, (latitude + moved, longitude), LED_NORTH, math.pi / 2)
        link.pump_for(0.1)
    link.pump_for(12)


def go_to_by_reposition(link: VehicleLink) -> None:
    """COMMAND_INT DO_REPOSITION in GUIDED; in LOITER without and with the change-mode flag; bad latitude."""
    airborne(link)
    start(link)
    target = north_of_here(link, 60)
    reposition(link, target, 30, 0)
    arrived(link, target)
    link.pump_for(2)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(3)
    reposition(link, north_of_here(link, -40), 30, 0)
    link.pump_for(3)
    reposition(link, north_of_here(link, -40), 30, 1)
    link.pump_for(6)
    reposition(link, (950_000_000, 0), 30, 1)
    link.pump_for(2)


def reposition(link: VehicleLink, target: tuple[int, int], altitude_meters: float, flags: int) -> int:
    """DO_REPOSITION and its result."""
    link.clear_inbox()
    link.command_int(
        mavlink.MAV_CMD_DO_REPOSITION,
        GLOBAL_RELATIVE,
        (-1, flags, 0, float("nan")),
        (*target, altitude_meters),
    )
    return link.wait_for_acknowledgement(mavlink.MAV_CMD_DO_REPOSITION)


def return_from(link: VehicleLink, altitude_meters: float) -> None:
    """60 m away, then RTL by command until disarmed."""
    airborne(link, altitude_meters)
    target = north_of_here(link, 60)
    go_to(link, target, altitude_meters)
    arrived(link, target)
    start(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    disarmed(link, 180)


def rtl_from_20_m(link: VehicleLink) -> None:
    """Above RTL_ALT: no climb."""
    return_from(link, 20)


def rtl_from_8_m(link: VehicleLink) -> None:
    """Below RTL_ALT (15 m): climbs first."""
    return_from(link, 8)


def rtl_close_to_home(link: VehicleLink) -> None:
    """RTL by mode change above home itself."""
    airborne(link, 8)
    start(link)
    link.set_mode_and_acknowledge("RTL")
    disarmed(link, 120)


def disarm_in_flight(link: VehicleLink) -> None:
    """Refused; then with the magic number 21196: accepted, it falls."""
    airborne(link)
    start(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0, 21196)
    link.pump_for(8)


def commands_twice(link: VehicleLink) -> None:
    """Second copies: arm, take-off on the way up and at the top, relative yaw, mode, land."""
    ready(link)
    link.set_mode_and_acknowledge("GUIDED")
    start(link)
    arm(link)
    arm(link)
    take_off(link, 10)
    take_off(link, 10)
    link.wait_until("5 m", lambda: link.altitude_meters > 5, 30)
    take_off(link, 10)
    link.wait_until("altitude", lambda: link.altitude_meters > 9.5, 60)
    link.pump_for(3)
    for confirmation in (0, 1):
        link.command_long(mavlink.MAV_CMD_CONDITION_YAW, 30, 20, 1, 1, confirmation=confirmation)
        link.pump_for(3)
    take_off(link, 15)
    link.pump_for(6)
    link.set_mode_and_acknowledge("GUIDED")
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
    link.pump_for(2)


def hold_in_flight(link: VehicleLink) -> None:
    """Stopping at cruise speed: GUIDED pause, BRAKE, LOITER with the throttle stick down, then in the middle."""
    airborne(link, 30)
    start(link)
    go_to(link, north_of_here(link, 300), 30)
    link.pump_for(8)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.pump_for(6)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 1)
    link.pump_for(1)
    go_to(link, north_of_here(link, 300), 30)
    link.pump_for(8)
    link.set_mode_and_acknowledge("BRAKE")
    link.pump_for(8)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(4)
    override_throttle(link, 1500)
    link.set_mode_and_acknowledge("LOITER")
    for _ in range(6):
        override_throttle(link, 1500)
        link.pump_for(1)


def override_throttle(link: VehicleLink, pulse_microseconds: int) -> None:
    """RC_CHANNELS_OVERRIDE of channel 3 alone."""
    link.send(
        mavlink.MAVLink_rc_channels_override_message(
            link.system_id, 1, UNCHANGED, UNCHANGED, pulse_microseconds, *([UNCHANGED] * 5)
        )
    )


def speed_and_home(link: VehicleLink) -> None:
    """DO_CHANGE_SPEED before the first leg (lost), before the second (kept); DO_SET_HOME, heard as HOME_POSITION."""
    airborne(link)
    start(link)
    for _ in range(2):
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, 1, 3, -1)
        target = north_of_here(link, 40)
        go_to(link, target, 20)
        arrived(link, target)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_HOME, 1)
    link.pump_for(3)
