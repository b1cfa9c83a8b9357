"""Exchanges about circles in missions and ways home: items that circle, SMART_RTL, rally points, a plane's fence."""

from __future__ import annotations

from collections.abc import Sequence

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from exchange import Exchange
from flying import arm, climb_to, disarmed, go_to, ready, start
from missions import clear
from plane_flying import (
    PlaneItem,
    at_item,
    circuit,
    from_the_ground,
    offset,
    reposition,
    take_off_by_mode,
    takeoff,
    upload_plane,
    waypoint,
)
from rover_driving import ready_to_drive, stopped
from vehicle_link import VehicleLink

LOITER_TURNS = int(mavlink.MAV_CMD_NAV_LOITER_TURNS)
LOITER_TIME = int(mavlink.MAV_CMD_NAV_LOITER_TIME)
LOITER_TO_ALT = int(mavlink.MAV_CMD_NAV_LOITER_TO_ALT)
RALLY = int(mavlink.MAV_MISSION_TYPE_RALLY)
RALLY_POINT = int(mavlink.MAV_CMD_NAV_RALLY_POINT)


def upload_rally_points(link: VehicleLink, points: Sequence[tuple[int, int]], up: float) -> int:
    """Rally points at those places, so high above home; the type of the MISSION_ACK."""
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_count_message(link.system_id, 1, len(points), RALLY))
    while True:
        message = link.expect(
            "MISSION_REQUEST or MISSION_ACK",
            lambda m: m.get_type() in ("MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ACK"),
            10,
        )
        if message.get_type() == "MISSION_ACK":
            return int(message.type)
        frame = int(mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT)
        place = points[message.seq]
        link.send(
            mavlink.MAVLink_mission_item_int_message(
                link.system_id, 1, message.seq, frame, RALLY_POINT, 0, 1, 0, 0, 0, 0, *place, up, RALLY
            )
        )


def mission_that_circles(link: VehicleLink) -> None:
    """A circle of 15 m, half a turn to the left at the default radius, 4 s at a place, a climb at a place, RTL."""
    ready(link)
    home = link.position
    items = [
        PlaneItem(int(mavlink.MAV_CMD_NAV_TAKEOFF), up=15, placed=False),
        PlaneItem(LOITER_TURNS, 40, 0, 15, (1, 0, 15, 0)),
        PlaneItem(LOITER_TURNS, 40, 40, 15, (0.5, 0, -10, 0)),
        PlaneItem(LOITER_TIME, 0, 40, 15, (4, 0, 0, 0)),
        PlaneItem(LOITER_TO_ALT, 20, 20, 22, (0, 0, 0, 0)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH), placed=False),
    ]
    start(link)
    upload_plane(link, items, home)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.set_mode_and_acknowledge("AUTO")
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    disarmed(link, 240)


def smart_return(link: VehicleLink) -> None:
    """North, then east, then SMART_RTL: back the way it came."""
    ready(link)
    home = link.position
    climb_to(link, 15)
    start(link)
    go_to(link, offset(home, 40, 0), 15)
    link.pump_for(15)
    go_to(link, offset(home, 40, 40), 15)
    link.pump_for(15)
    link.set_mode_and_acknowledge("SMART_RTL")
    disarmed(link, 180)


def return_to_rally_point(link: VehicleLink) -> None:
    """A rally point 60 m east; from 60 m north RTL goes to home, from 50 m east to the point."""
    ready(link)
    home = link.position
    upload_rally_points(link, [offset(home, 0, 60)], 20)
    climb_to(link, 15)
    start(link)
    go_to(link, offset(home, 0, 50), 15)
    link.pump_for(15)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    disarmed(link, 180)


def rover_mission_that_circles(link: VehicleLink) -> None:
    """A circle of 10 m, 3 s at a place, a loiter to a height, which it does not drive."""
    ready(link)
    home = link.position
    items = [
        PlaneItem(LOITER_TURNS, 30, 0, 0, (1, 0, 10, 0)),
        PlaneItem(LOITER_TIME, 30, 30, 0, (3, 0, 0, 0)),
        PlaneItem(LOITER_TO_ALT, 0, 30, 20, (0, 0, 0, 0)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_WAYPOINT), 0, 20, 0),
    ]
    start(link)
    upload_plane(link, items, home)
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    at_item(link, 4, 180)
    stopped(link, 120)


def rover_smart_return(link: VehicleLink) -> None:
    """North, then east, then SMART_RTL: back the way it came."""
    ready_to_drive(link)
    home = link.position
    go_to(link, offset(home, 30, 0), 0)
    stopped(link)
    go_to(link, offset(home, 30, 30), 0)
    stopped(link)
    link.set_mode_and_acknowledge("SMART_RTL")
    stopped(link)
    link.pump_for(10)


def plane_return_to_rally_point(link: VehicleLink) -> None:
    """Rally points 500 m north and south; RTL in the north circles at the one there."""
    home = from_the_ground(link)
    upload_rally_points(link, [offset(home, 500, 0), offset(home, -500, 0)], 80)
    take_off_by_mode(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    link.pump_for(90)


def plane_fence_breached(link: VehicleLink) -> None:
    """A circle of 300 m: GUIDED leads out of it, the breach brings it home; then the fence is switched off."""
    home = from_the_ground(link)
    take_off_by_mode(link)
    link.set_parameter("FENCE_ENABLE", 1)
    reposition(link, offset(home, 0, 900), 60, flags=1)
    link.wait_until("RTL", lambda: link.mode == "RTL", 120)
    link.pump_for(60)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_FENCE_ENABLE, 0)
    link.pump_for(5)


def plane_mission_cleared_after_landing(link: VehicleLink) -> None:
    """A mission up and down again; once it has disarmed itself in AUTO it is cleared, and once more in MANUAL."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    disarmed(link, 300)
    link.pump_for(2)
    clear(link)
    link.pump_for(3)
    link.set_mode_and_acknowledge("MANUAL")
    link.pump_for(1)
    clear(link)
    link.pump_for(2)


def plane_mission_that_jumps(link: VehicleLink) -> None:
    """Two waypoints, a jump back to the first of them, once, and RTL."""
    home = from_the_ground(link)
    items = [
        takeoff(40),
        waypoint(300, 0, 60),
        waypoint(300, 300, 60),
        PlaneItem(int(mavlink.MAV_CMD_DO_JUMP), params=(2, 1, 0, 0), placed=False),
        PlaneItem(int(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH), placed=False),
    ]
    upload_plane(link, items, home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    link.wait_until("RTL", lambda: link.mode == "RTL", 240)
    link.pump_for(5)


COPTER_RETURNS: tuple[Exchange, ...] = (
    Exchange("mission_that_circles", "LOITER_TURNS, LOITER_TIME, LOITER_TO_ALT", mission_that_circles),
    Exchange("smart_return", "SMART_RTL", smart_return),
    Exchange("return_to_rally_point", "RTL with a rally point that is nearer than home", return_to_rally_point),
)
ROVER_RETURNS: tuple[Exchange, ...] = (
    Exchange("rover_mission_that_circles", "LOITER_TURNS, LOITER_TIME, LOITER_TO_ALT", rover_mission_that_circles),
    Exchange("rover_smart_return", "SMART_RTL", rover_smart_return),
)
PLANE_RETURNS: tuple[Exchange, ...] = (
    Exchange("plane_return_to_rally_point", "RTL with two rally points", plane_return_to_rally_point),
    Exchange(
        "plane_fence_breached",
        "GUIDED leads out of the circle",
        plane_fence_breached,
        {"FENCE_TYPE": 2, "FENCE_RADIUS": 300, "FENCE_ACTION": 1},
    ),
    Exchange("plane_mission_that_jumps", "DO_JUMP back to a waypoint, once", plane_mission_that_jumps),
    Exchange(
        "plane_mission_cleared_after_landing",
        "MISSION_CLEAR_ALL where a mission has landed it",
        plane_mission_cleared_after_landing,
        {"RTL_AUTOLAND": 3},
    ),
)
