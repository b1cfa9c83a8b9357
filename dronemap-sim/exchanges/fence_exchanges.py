"""Exchanges about the fence on board: taken, refused, and breached."""

from __future__ import annotations

from collections.abc import Sequence

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flight_exchanges import reposition
from flying import DEGREES_E7_PER_METER_NORTH, airborne, arm, climb_to, disarmed, go_to, north_of_here, ready, start
from missions import Item, fly_square, upload
from vehicle_link import VehicleLink

POLYGON_INCLUSION = int(mavlink.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION)
CIRCLE_EXCLUSION = int(mavlink.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION)
FENCE = int(mavlink.MAV_MISSION_TYPE_FENCE)
STATUS_MICROSECONDS = 200_000
Corner = tuple[int, float, float]


def watch_fence(link: VehicleLink) -> None:
    """FENCE_STATUS five times a second."""
    link.send_and_acknowledge(
        mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, mavlink.MAVLINK_MSG_ID_FENCE_STATUS, STATUS_MICROSECONDS
    )


def square(command: int, half_meters: float, north: float = 0) -> list[Corner]:
    """Corners of a square around a place so far north of here: command, metres north and east."""
    return [(command, north + dn * half_meters, de * half_meters) for dn, de in ((1, 1), (1, -1), (-1, -1), (-1, 1))]


def upload_fence(link: VehicleLink, corners: Sequence[Corner], count: int | None = None) -> int:
    """The fence by the mission protocol, each corner with `count` (default: all); the type of the MISSION_ACK."""
    latitude, longitude = link.position
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_count_message(link.system_id, 1, len(corners), FENCE))
    while True:
        message = link.expect(
            "MISSION_REQUEST or MISSION_ACK",
            lambda m: m.get_type() in ("MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ACK"),
            10,
        )
        if message.get_type() == "MISSION_ACK":
            return int(message.type)
        command, north, east = corners[message.seq]
        link.send(
            mavlink.MAVLink_mission_item_int_message(
                link.system_id,
                1,
                message.seq,
                mavlink.MAV_FRAME_GLOBAL,
                command,
                0,
                1,
                len(corners) if count is None else count,
                0,
                0,
                0,
                latitude + round(north * DEGREES_E7_PER_METER_NORTH),
                longitude + round(east * 1.226 * DEGREES_E7_PER_METER_NORTH),
                0,
                FENCE,
            )
        )


def download_fence(link: VehicleLink) -> None:
    """Read the fence back whole."""
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_request_list_message(link.system_id, 1, FENCE))
    count = int(link.expect("MISSION_COUNT", lambda m: m.get_type() == "MISSION_COUNT", 5).count)
    for sequence in range(count):
        link.send(mavlink.MAVLink_mission_request_int_message(link.system_id, 1, sequence, FENCE))
        link.expect(f"corner {sequence}", lambda m: m.get_type() == "MISSION_ITEM_INT", 5)


def clear_fence(link: VehicleLink) -> None:
    """MISSION_CLEAR_ALL of the fence."""
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_clear_all_message(link.system_id, 1, FENCE))
    link.expect("MISSION_ACK", lambda m: m.get_type() == "MISSION_ACK", 5)


def fence_upload(link: VehicleLink) -> None:
    """A polygon and a circle; then two corners alone, an unknown command, corners with another count; cleared."""
    ready(link)
    start(link)
    upload_fence(link, square(POLYGON_INCLUSION, 100))
    download_fence(link)
    upload_fence(link, [(CIRCLE_EXCLUSION, 300, 0)], count=25)
    download_fence(link)
    upload_fence(link, square(POLYGON_INCLUSION, 100)[:2])
    link.pump_for(1)
    upload_fence(link, [(16, 0, 0), (16, 0, 10), (16, 10, 0)])
    link.pump_for(1)
    upload_fence(link, square(POLYGON_INCLUSION, 100), count=7)
    link.pump_for(1)
    download_fence(link)
    clear_fence(link)
    download_fence(link)


def fence_switched(link: VehicleLink) -> None:
    """DO_FENCE_ENABLE with nothing selected, then off; on, by the parameter, with the default circle and height."""
    ready(link)
    watch_fence(link)
    start(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_FENCE_ENABLE, 1)
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_FENCE_ENABLE, 0)
    link.pump_for(2)
    link.set_parameter("FENCE_ENABLE", 1)
    link.pump_for(2)
    link.set_parameter("FENCE_TYPE", 0)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_FENCE_ENABLE, 1)
    link.pump_for(2)


def fence_arming_outside(link: VehicleLink) -> None:
    """A polygon 300 m north of where it stands: arming is refused; cleared, and it is granted."""
    ready(link)
    watch_fence(link)
    start(link)
    upload_fence(link, square(POLYGON_INCLUSION, 50, north=300))
    link.set_parameter("FENCE_TYPE", 4)
    link.set_parameter("FENCE_ENABLE", 1)
    link.pump_for(4)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(2)
    link.set_parameter("FENCE_ENABLE", 0)
    link.pump_for(3)
    arm(link)
    link.pump_for(2)


def fence_targets_outside(link: VehicleLink) -> None:
    """Circle 60 m, height 40 m: targets beyond both, as a setpoint and as DO_REPOSITION; then one inside."""
    airborne(link)
    watch_fence(link)
    start(link)
    go_to(link, north_of_here(link, 150), 20)
    link.pump_for(3)
    go_to(link, north_of_here(link, 30), 60)
    link.pump_for(3)
    reposition(link, north_of_here(link, 150), 20, 0)
    link.pump_for(3)
    reposition(link, north_of_here(link, 30), 60, 0)
    link.pump_for(3)
    reposition(link, north_of_here(link, 30), 20, 0)
    link.pump_for(8)


def fence_breached_in_auto(link: VehicleLink) -> None:
    """A mission that leads out of the circle of 60 m: AUTO takes it, the breach brings it home."""
    ready(link)
    watch_fence(link)
    latitude, longitude = link.position
    home = fly_square(link.position)[0]
    out = latitude + round(150 * DEGREES_E7_PER_METER_NORTH)
    upload(link, [home, Item(int(mavlink.MAV_CMD_NAV_WAYPOINT), out, longitude, 20)])
    climb_to(link, 20)
    link.pump_for(3)
    start(link)
    link.pump_for(0.6)
    link.set_mode_and_acknowledge("AUTO")
    disarmed(link, 180)
    link.pump_for(2)


def fence_breached_in_height(link: VehicleLink) -> None:
    """Circle 60 m, height 40 m: a take-off to 42 m."""
    ready(link)
    watch_fence(link)
    start(link)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 42)
    link.wait_until("RTL", lambda: link.mode == "RTL", 90)
    disarmed(link, 180)


def fence_breach_only_told(link: VehicleLink) -> None:
    """FENCE_ACTION 0: out of the circle of 60 m in AUTO and back by GUIDED."""
    ready(link)
    watch_fence(link)
    latitude, longitude = link.position
    home = fly_square(link.position)[0]
    out = latitude + round(75 * DEGREES_E7_PER_METER_NORTH)
    upload(link, [home, Item(int(mavlink.MAV_CMD_NAV_WAYPOINT), out, longitude, 20)])
    climb_to(link, 20)
    link.pump_for(3)
    start(link)
    link.pump_for(0.6)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(45)
    link.set_mode_and_acknowledge("GUIDED")
    go_to(link, (latitude, longitude), 20)
    link.pump_for(20)
