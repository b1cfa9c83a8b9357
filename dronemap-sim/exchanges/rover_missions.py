"""Exchanges with an ArduRover about its mission. Each begins where the vehicle stands, in MANUAL."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import arm, ready, start
from missions import Item, clear, download, upload
from rover_driving import WAYPOINT, drive
from vehicle_link import VehicleLink


def mission_upload(link: VehicleLink) -> None:
    """Items of aircraft, items that it does not know, hold seconds with a fraction, read back, cleared."""
    ready(link)
    start(link)
    items = drive(link.position)
    latitude, longitude = link.position
    aircraft = (
        Item(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 10),
        Item(mavlink.MAV_CMD_NAV_LAND, latitude, longitude, 0),
        Item(mavlink.MAV_CMD_NAV_LOITER_TIME, latitude, longitude, 0, param1=2),
        Item(mavlink.MAV_CMD_NAV_DELAY, 0, 0, 0, param1=2),
        Item(mavlink.MAV_CMD_DO_CHANGE_SPEED, 0, 0, 0, param1=1, param2=2),
        Item(mavlink.MAV_CMD_CONDITION_YAW, 0, 0, 0, param1=90),
        Item(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0, 0),
    )
    upload(link, [*items[:2], *aircraft])
    download(link)
    upload(link, [*items[:2], Item(WAYPOINT, latitude, longitude, 0, param1=2.5)])
    download(link)
    for unknown in (mavlink.MAV_CMD_NAV_LOITER_TO_ALT, mavlink.MAV_CMD_NAV_SPLINE_WAYPOINT, 31000):
        upload(link, [*items[:2], Item(unknown, latitude, longitude, 0), *items[3:]])
        link.pump_for(0.5)
    download(link)
    clear(link)
    download(link)


def mission_drive(link: VehicleLink) -> None:
    """AUTO by MISSION_START from HOLD: waypoints, a wait of 3 s, complete; then MISSION_START and AUTO once more."""
    ready(link)
    start(link)
    link.pump_for(1)
    upload(link, drive(link.position))
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(1)
    arm(link)
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    complete(link)
    link.pump_for(5)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.pump_for(3)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.pump_for(8)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def complete(link: VehicleLink, seconds: float = 120) -> None:
    """Wait for the sentence that ends a mission."""
    link.expect(
        "Mission Complete", lambda m: m.get_type() == "STATUSTEXT" and m.text.startswith("Mission Complete"), seconds
    )


def mission_of_aircraft(link: VehicleLink) -> None:
    """A take-off, a change of speed, a waypoint, a landing, a delay, a turn and a return, driven."""
    ready(link)
    start(link)
    link.pump_for(1)
    items = drive(link.position)
    latitude, longitude = link.position
    upload(
        link,
        [
            items[0],
            Item(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 10),
            Item(mavlink.MAV_CMD_DO_CHANGE_SPEED, 0, 0, 0, param1=1, param2=3),
            items[1],
            Item(mavlink.MAV_CMD_NAV_LAND, latitude, longitude, 0),
            Item(mavlink.MAV_CMD_NAV_DELAY, 0, 0, 0, param1=2),
            Item(mavlink.MAV_CMD_NAV_LOITER_TIME, items[1].latitude, items[1].longitude, 0, param1=2),
            Item(mavlink.MAV_CMD_CONDITION_YAW, 0, 0, 0, param1=90),
            Item(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0, 0),
        ],
    )
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    complete(link)
    link.pump_for(5)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def mission_paused(link: VehicleLink) -> None:
    """HOLD and AUTO again, the pause that it does not know, another item, clearing while it drives."""
    ready(link)
    start(link)
    link.pump_for(1)
    upload(link, drive(link.position))
    link.set_mode_and_acknowledge("HOLD")
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    link.wait_until("item 2", lambda: link.last["MISSION_CURRENT"].seq == 2, 30)
    link.pump_for(2)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(6)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.pump_for(1)
    link.send(mavlink.MAVLink_mission_set_current_message(link.system_id, 1, 4))
    link.pump_for(3)
    clear(link)
    link.pump_for(2)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MISSION_CURRENT, 2)
    link.pump_for(2)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(4)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(3)
