"""Steps that the exchanges with an ArduPlane share: taking off, missions that it can land with, going somewhere."""

from __future__ import annotations

from dataclasses import dataclass

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import DEGREES_E7_PER_METER_NORTH, GLOBAL_RELATIVE, arm, ready, start
from missions import next_mission_message, send_count
from vehicle_link import VehicleLink

EAST_OF_NORTH = 1.226  # degrees of longitude to degrees of latitude at the recording's place


@dataclass(frozen=True)
class PlaneItem:
    """One mission item: where in metres north and east of home, `up` in metres above it, and its four parameters."""

    command: int
    north: float = 0
    east: float = 0
    up: float = 0
    params: tuple[float, float, float, float] = (0, 0, 0, 0)
    placed: bool = True


def upload_plane(link: VehicleLink, items: list[PlaneItem], home: tuple[int, int]) -> int:
    """The items with a home before them, and a moment to hear of them; the type of the MISSION_ACK."""
    link.clear_inbox()
    everything = [PlaneItem(int(mavlink.MAV_CMD_NAV_WAYPOINT)), *items]
    send_count(link, len(everything))
    while True:
        message = next_mission_message(link)
        if message.get_type() == "MISSION_ACK":
            link.pump_for(0.5)
            return int(message.type)
        send_plane_item(link, message.seq, everything[message.seq], home)


def send_plane_item(link: VehicleLink, sequence: int, item: PlaneItem, home: tuple[int, int]) -> None:
    """One item in answer to a request."""
    frame = mavlink.MAV_FRAME_GLOBAL if sequence == 0 else mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT
    x, y = offset(home, item.north, item.east) if item.placed else (0, 0)
    link.send(
        mavlink.MAVLink_mission_item_int_message(
            link.system_id, 1, sequence, frame, item.command, 0, 1, *item.params, x, y, item.up
        )
    )


def offset(home: tuple[int, int], north: float, east: float) -> tuple[int, int]:
    """Degrees × 10⁷ of a place so many metres from home."""
    return (
        home[0] + round(north * DEGREES_E7_PER_METER_NORTH),
        home[1] + round(east * DEGREES_E7_PER_METER_NORTH * EAST_OF_NORTH),
    )


def takeoff(up: float, pitch: float = 15) -> PlaneItem:
    """NAV_TAKEOFF: a climb straight ahead, whatever its place."""
    return PlaneItem(int(mavlink.MAV_CMD_NAV_TAKEOFF), up=up, params=(pitch, 0, 0, 0), placed=False)


def waypoint(north: float, east: float, up: float, hold: float = 0) -> PlaneItem:
    """NAV_WAYPOINT; `hold` is what a plane takes as the radius to accept it by."""
    return PlaneItem(int(mavlink.MAV_CMD_NAV_WAYPOINT), north, east, up, (hold, 0, 0, 0))


def land(north: float, east: float, *, placed: bool = True) -> PlaneItem:
    """NAV_LAND at a place, or with 0/0."""
    return PlaneItem(int(mavlink.MAV_CMD_NAV_LAND), north, east, 0, placed=placed)


def do_land_start() -> PlaneItem:
    """DO_LAND_START: where the landing begins."""
    return PlaneItem(int(mavlink.MAV_CMD_DO_LAND_START), placed=False)


def circuit() -> list[PlaneItem]:
    """Up to the north, round to the east, and an approach from the south-east back to home."""
    return [
        takeoff(40),
        waypoint(400, 0, 60),
        waypoint(400, 400, 60),
        waypoint(-500, 400, 50),
        do_land_start(),
        waypoint(-600, 0, 35),
        waypoint(-300, 0, 18),
        land(0, 0),
    ]


def from_the_ground(link: VehicleLink) -> tuple[int, int]:
    """Ready, with everything that is said from now on in the file; the place where it stands."""
    ready(link)
    start(link)
    link.pump_for(1)
    return link.position


def take_off_by_mode(link: VehicleLink) -> None:
    """TAKEOFF, armed, up to where it circles."""
    link.set_mode_and_acknowledge("TAKEOFF")
    link.wait_until("TAKEOFF", lambda: link.mode == "TAKEOFF", 5)
    arm(link)
    link.wait_until("45 m", lambda: link.altitude_meters > 45, 90)
    link.pump_for(10)


def reposition(link: VehicleLink, place: tuple[int, int], up: float, *, flags: int = 0, radius: float = 0) -> int:
    """DO_REPOSITION as COMMAND_INT, and its result."""
    link.clear_inbox()
    link.command_int(mavlink.MAV_CMD_DO_REPOSITION, GLOBAL_RELATIVE, (-1, flags, radius, float("nan")), (*place, up))
    return link.wait_for_acknowledgement(mavlink.MAV_CMD_DO_REPOSITION)


def at_item(link: VehicleLink, sequence: int, seconds: float) -> None:
    """Wait until the mission is at that item."""
    link.wait_until(f"item {sequence}", lambda: link.last["MISSION_CURRENT"].seq == sequence, seconds)
