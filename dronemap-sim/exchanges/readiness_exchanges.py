"""Exchanges about readiness: what is possible in which mode, when, and what is said of it."""

from __future__ import annotations

from collections.abc import Sequence

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import ACCEPTED, airborne, arm, disarmed, ready, start
from missions import fly_square, upload
from vehicle_link import VehicleLink

GPS_RATE_MICROSECONDS = 500_000


def ask_to_arm(link: VehicleLink, modes: Sequence[str]) -> list[str]:
    """In which of these modes it would arm now; it is disarmed again."""
    granted = []
    for mode in modes:
        link.set_mode_and_acknowledge(mode)
        if link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == ACCEPTED:
            link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
            granted.append(mode)
    return granted


def readiness_by_mode(link: VehicleLink) -> None:
    """From power-up: arming asked in STABILIZE and in GUIDED every 2 s until GUIDED is granted."""
    start(link)
    link.request_rates()
    request_gps(link)
    for _ in range(40):
        if "GUIDED" in ask_to_arm(link, ("STABILIZE", "GUIDED")):
            break
        link.pump_for(2)
    link.pump_for(3)


def request_gps(link: VehicleLink) -> None:
    """GPS_RAW_INT twice a second."""
    link.send_and_acknowledge(
        mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, mavlink.MAVLINK_MSG_ID_GPS_RAW_INT, GPS_RATE_MICROSECONDS
    )


def gps_back_on_ground(link: VehicleLink) -> None:
    """GPS gone for 15 s before arming and back: arming asked in GUIDED every 2 s until granted."""
    ready(link)
    request_gps(link)
    link.set_mode_and_acknowledge("GUIDED")
    start(link)
    link.pump_for(0.6)
    link.set_parameter("SIM_GPS_DISABLE", 1)
    link.pump_for(15)
    ask_to_arm(link, ("GUIDED",))
    link.set_parameter("SIM_GPS_DISABLE", 0)
    for _ in range(20):
        link.pump_for(2)
        if ask_to_arm(link, ("GUIDED",)):
            break
    link.pump_for(3)


def modes_without_gps_in_flight(link: VehicleLink) -> None:
    """GPS gone at 20 m: after the fail-safe LOITER, GUIDED and RTL are asked for, then ALT_HOLD, then LAND."""
    airborne(link)
    start(link)
    link.set_parameter("SIM_GPS_DISABLE", 1)
    link.wait_until("LAND", lambda: link.mode == "LAND", 30)
    link.pump_for(1)
    for mode in ("LOITER", "GUIDED", "RTL", "BRAKE", "ALT_HOLD", "LAND"):
        link.set_mode_and_acknowledge(mode)
        link.pump_for(0.5)
    link.pump_for(3)


def gps_gap_in_flight(link: VehicleLink) -> None:
    """GPS gone at 20 m for 4 s, which is shorter than the fail-safe waits, and back; then a second gap."""
    airborne(link)
    request_gps(link)
    start(link)
    for _ in range(2):
        link.set_parameter("SIM_GPS_DISABLE", 1)
        link.pump_for(4)
        link.set_parameter("SIM_GPS_DISABLE", 0)
        link.pump_for(8)


def arm_after_mission(link: VehicleLink) -> None:
    """A mission with RTL at its end is flown; then arming is asked for in AUTO, and in GUIDED."""
    ready(link)
    upload(link, fly_square(link.position))
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.set_mode_and_acknowledge("AUTO")
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.wait_until("disarmed", lambda: not link.armed, 240)
    link.pump_for(2)
    start(link)
    for mode in ("AUTO", "GUIDED"):
        link.set_mode_and_acknowledge(mode)
        link.pump_for(1)
        arm(link)
        link.pump_for(1)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        link.pump_for(1)


def arm_after_rtl(link: VehicleLink) -> None:
    """After a return to launch arming is refused in RTL; GUIDED is the way out."""
    airborne(link, 8)
    link.set_mode_and_acknowledge("RTL")
    disarmed(link, 120)
    start(link)
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(3)
