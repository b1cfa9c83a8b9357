"""Exchanges with an ArduPlane that stands where its mission landed it."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import arm, disarmed
from missions import clear
from plane_flying import from_the_ground, land, takeoff, upload_plane, waypoint
from vehicle_link import VehicleLink

ROUND_TRIP = [takeoff(40), waypoint(400, 0, 50), waypoint(800, 0, 30), land(1200, 0)]


def landed(link: VehicleLink) -> tuple[int, int]:
    """Its mission is flown to its end, disarmed and in AUTO still; where its home is."""
    home = from_the_ground(link)
    upload_plane(link, ROUND_TRIP, home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    disarmed(link, 240)
    return home


def landed_by_mission(link: VehicleLink) -> None:
    """What keeps it from arming after a landing: refused in AUTO, granted in GUIDED."""
    landed(link)
    arm(link)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(2)
    arm(link)
    link.pump_for(2)


def landed_and_cleared(link: VehicleLink) -> None:
    """The mission is cleared before the mode is changed: refused in GUIDED until the mission begins with a take-off."""
    home = landed(link)
    clear(link)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(2)
    arm(link)
    upload_plane(link, ROUND_TRIP, home)
    arm(link)
    link.pump_for(1)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def landed_and_manual(link: VehicleLink) -> None:
    """The same; a mode in which a pilot flies ends it as well."""
    landed(link)
    clear(link)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(2)
    arm(link)
    link.set_mode_and_acknowledge("MANUAL")
    link.pump_for(1)
    arm(link)
    link.pump_for(2)
