"""Exchanges with an ArduPlane that has lift motors (a QuadPlane)."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import ACCEPTED, arm, disarmed, take_off
from plane_flying import PlaneItem, from_the_ground, offset, reposition, upload_plane, waypoint
from vehicle_link import VehicleLink


def lift_to(link: VehicleLink, up: float) -> None:
    """GUIDED, armed, NAV_TAKEOFF, and the height."""
    from_the_ground(link)
    link.set_mode_and_acknowledge("GUIDED")
    link.wait_until("GUIDED", lambda: link.mode == "GUIDED", 5)
    arm(link)
    take_off(link, up)
    link.wait_until("height", lambda: link.altitude_meters > up - 1, 60)
    link.pump_for(5)


def modes_on_ground(link: VehicleLink) -> None:
    """Arming in the modes of the lift motors and in others."""
    from_the_ground(link)
    for name in ("QSTABILIZE", "QHOVER", "QLOITER", "QLAND", "QRTL", "LOITER", "RTL", "AUTO", "GUIDED"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1)
        if arm(link) == ACCEPTED:
            link.pump_for(1)
            link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        link.pump_for(1)


def guided_takeoff(link: VehicleLink) -> None:
    """NAV_TAKEOFF refused disarmed and outside GUIDED; granted in GUIDED; holds; QLAND; disarmed."""
    from_the_ground(link)
    take_off(link, 20)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(1)
    take_off(link, 20)
    arm(link)
    link.pump_for(1)
    take_off(link, 20)
    link.wait_until("19 m", lambda: link.altitude_meters > 19, 60)
    link.pump_for(10)
    link.set_mode_and_acknowledge("QLAND")
    disarmed(link, 120)


def guided_flight(link: VehicleLink) -> None:
    """From a hover to a place 500 m away as a fixed wing; circles there; QRTL: home, down, disarmed."""
    lift_to(link, 30)
    home = link.position
    reposition(link, offset(home, 500, 0), 60)
    link.pump_for(60)
    link.set_mode_and_acknowledge("QRTL")
    disarmed(link, 240)


def hover_modes(link: VehicleLink) -> None:
    """QLOITER, QHOVER and QSTABILIZE with the throttle stick at the bottom; then QLAND."""
    lift_to(link, 30)
    link.set_mode_and_acknowledge("QLOITER")
    link.pump_for(4)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(6)
    link.set_mode_and_acknowledge("QLAND")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
    disarmed(link, 120)


def mission_flight(link: VehicleLink) -> None:
    """VTOL take-off, two waypoints, VTOL landing at home, disarmed."""
    home = from_the_ground(link)
    items = [
        PlaneItem(int(mavlink.MAV_CMD_NAV_VTOL_TAKEOFF), up=30, placed=False),
        waypoint(400, 0, 50),
        waypoint(400, 300, 50),
        PlaneItem(int(mavlink.MAV_CMD_NAV_VTOL_LAND)),
    ]
    upload_plane(link, items, home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    disarmed(link, 300)


def rtl(link: VehicleLink) -> None:
    """RTL in a hover above home: it goes over to its wings and circles, and does not come down."""
    lift_to(link, 30)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    link.pump_for(50)


def rtl_lands(link: VehicleLink) -> None:
    """RTL with Q_RTL_MODE 1 from 400 m away on its wings: QRTL once it is home, down, disarmed."""
    lift_to(link, 30)
    reposition(link, offset(link.position, 400, 0), 50)
    link.pump_for(35)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    disarmed(link, 240)


def ground_station_lost(link: VehicleLink) -> None:
    """Heartbeats stop for 30 s in a hover in GUIDED (FS_GCS_ENABL 1, FS_LONG_ACTN 1)."""
    lift_to(link, 30)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(30)
    link.heartbeats_on = True
    link.pump_for(10)
