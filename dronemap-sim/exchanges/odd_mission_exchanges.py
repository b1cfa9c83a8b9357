"""Exchanges about missions with items that are not flown, jump back, or change the speed."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import arm, climb_to, disarmed, ready, start
from missions import DEGREES_E7_PER_METER_NORTH, Item, download, upload
from vehicle_link import VehicleLink

WAYPOINT = int(mavlink.MAV_CMD_NAV_WAYPOINT)


def mission_with_tasks(link: VehicleLink) -> None:
    """Look at home, hold 8.5 s, speed 3 m/s, climb on the way (plane's), jump back once, look ahead, RTL."""
    ready(link)
    latitude, longitude = link.position
    north = latitude + round(60 * DEGREES_E7_PER_METER_NORTH)
    items = [
        Item(WAYPOINT, latitude, longitude, 0),
        Item(int(mavlink.MAV_CMD_NAV_TAKEOFF), 0, 0, 15),
        Item(int(mavlink.MAV_CMD_DO_SET_ROI), latitude, longitude, 0),
        Item(WAYPOINT, north, longitude, 15, 8.5, 0),
        Item(int(mavlink.MAV_CMD_DO_CHANGE_SPEED), 0, 0, 0, 1, 3),
        Item(int(mavlink.MAV_CMD_NAV_CONTINUE_AND_CHANGE_ALT), 0, 0, 15, 1, 0),
        Item(WAYPOINT, latitude, longitude, 15),
        Item(int(mavlink.MAV_CMD_DO_JUMP), 0, 0, 0, 6, 1),
        Item(int(mavlink.MAV_CMD_DO_SET_ROI), 0, 0, 0),
        Item(int(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH), 0, 0, 0),
    ]
    start(link)
    upload(link, items)
    download(link)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.set_mode_and_acknowledge("AUTO")
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    disarmed(link, 240)


def mission_refused_for_one_item(link: VehicleLink) -> None:
    """A good mission, then one with DO_SET_ROI_LOCATION and one with DO_SET_ROI_NONE: what is left on board."""
    ready(link)
    latitude, longitude = link.position
    home = Item(WAYPOINT, latitude, longitude, 0)
    takeoff = Item(int(mavlink.MAV_CMD_NAV_TAKEOFF), 0, 0, 15)
    out = Item(WAYPOINT, latitude + 5_000, longitude, 15)
    start(link)
    link.pump_for(0.6)
    upload(link, [home, takeoff, out, out])
    upload(link, [home, takeoff, Item(int(mavlink.MAV_CMD_DO_SET_ROI_LOCATION), latitude, longitude, 0), out])
    download(link)
    upload(link, [home, takeoff, Item(int(mavlink.MAV_CMD_DO_SET_ROI_NONE), 0, 0, 0), out])
    upload(link, [home, takeoff, Item(int(mavlink.MAV_CMD_DO_JUMP), 0, 0, 0, 9, 1), out])
    upload(link, [home, takeoff, Item(int(mavlink.MAV_CMD_DO_JUMP), 0, 0, 0, 0, 1), out])
    download(link)
    link.pump_for(2)


def speed_in_auto(link: VehicleLink) -> None:
    """DO_CHANGE_SPEED on a leg of 150 m in AUTO: to 4 m/s, to nothing, to less than nothing, of a kind that is none."""
    ready(link)
    latitude, longitude = link.position
    out = latitude + round(150 * DEGREES_E7_PER_METER_NORTH)
    upload(link, [Item(WAYPOINT, latitude, longitude, 0), Item(WAYPOINT, out, longitude, 20)])
    climb_to(link, 20)
    start(link)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(6)
    for kind, speed in ((1, 4.0), (1, 0.0), (1, -2.0), (9, 4.0)):
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, kind, speed, -1)
        link.pump_for(6)
