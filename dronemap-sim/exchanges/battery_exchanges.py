"""Exchanges about more than one battery."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import airborne, arm, disarmed, ready, start
from vehicle_link import VehicleLink

RATE_MICROSECONDS = 2_000_000


def two_batteries(link: VehicleLink) -> None:
    """BATTERY_STATUS of two monitors, on the ground and in flight."""
    ready(link)
    start(link)
    link.send_and_acknowledge(
        mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, mavlink.MAVLINK_MSG_ID_BATTERY_STATUS, RATE_MICROSECONDS
    )
    link.pump_for(5)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 10)
    link.pump_for(18)


def second_battery_low(link: VehicleLink) -> None:
    """The second battery falls under its own low voltage, whose action is RTL."""
    airborne(link)
    start(link)
    link.set_parameter("BATT2_FS_LOW_ACT", 2)
    link.set_parameter("BATT2_LOW_VOLT", 13)
    disarmed(link, 120)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(3)
