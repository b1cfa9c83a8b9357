"""The mission protocol from the ground station's side, plain and without retries: loopback loses nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from vehicle_link import VehicleLink

DEGREES_E7_PER_METER_NORTH = 1e7 / 111_319.5
ITEM_REQUESTS = ("MISSION_REQUEST", "MISSION_REQUEST_INT")


@dataclass(frozen=True)
class Item:
    """One mission item: degrees × 10⁷, metres above home; the first two of its parameters."""

    command: int
    latitude: int
    longitude: int
    altitude_meters: float
    param1: float = 0
    param2: float = 0


def fly_square(home: tuple[int, int]) -> list[Item]:
    """Six items: home (ArduPilot keeps it as item 0), take-off to 20 m, three waypoints 40 m apart, RTL."""
    latitude, longitude = home
    north = round(40 * DEGREES_E7_PER_METER_NORTH)
    east = round(north * 1.226)  # at the recording's latitude of 35.4 degrees
    waypoint = int(mavlink.MAV_CMD_NAV_WAYPOINT)
    return [
        Item(waypoint, latitude, longitude, 0),
        Item(int(mavlink.MAV_CMD_NAV_TAKEOFF), 0, 0, 20),
        Item(waypoint, latitude + north, longitude, 20),
        Item(waypoint, latitude + north, longitude + east, 25),
        Item(waypoint, latitude, longitude + east, 20),
        Item(int(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH), 0, 0, 0),
    ]


def upload(link: VehicleLink, items: Sequence[Item]) -> int:
    """MISSION_COUNT, answer each request, return the type of the MISSION_ACK."""
    link.clear_inbox()
    send_count(link, len(items))
    while True:
        message = next_mission_message(link)
        if message.get_type() == "MISSION_ACK":
            return int(message.type)
        send_item(link, message.seq, items[message.seq])


def upload_until(link: VehicleLink, items: Sequence[Item], skipping: int) -> None:
    """An upload that goes silent at item `skipping`."""
    link.clear_inbox()
    send_count(link, len(items))
    while True:
        message = next_mission_message(link)
        if message.seq == skipping:
            return
        send_item(link, message.seq, items[message.seq])


def send_out_of_turn(link: VehicleLink, items: Sequence[Item]) -> None:
    """Item 3 in answer to the request for item 0."""
    link.clear_inbox()
    send_count(link, len(items))
    next_mission_message(link)
    send_item(link, 3, items[3])


def download(link: VehicleLink) -> int:
    """Read the mission back whole; return the count."""
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_request_list_message(link.system_id, 1))
    count = int(link.expect("MISSION_COUNT", lambda m: m.get_type() == "MISSION_COUNT", 5).count)
    for sequence in range(count):
        link.send(mavlink.MAVLink_mission_request_int_message(link.system_id, 1, sequence))
        link.expect(f"item {sequence}", lambda m: m.get_type() == "MISSION_ITEM_INT", 5)
    if count:
        link.send(mavlink.MAVLink_mission_ack_message(link.system_id, 1, mavlink.MAV_MISSION_ACCEPTED))
    return count


def clear(link: VehicleLink) -> int:
    """MISSION_CLEAR_ALL and the type of its MISSION_ACK."""
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_clear_all_message(link.system_id, 1))
    return int(link.expect("MISSION_ACK", lambda m: m.get_type() == "MISSION_ACK", 5).type)


def next_mission_message(link: VehicleLink) -> Any:
    """The next request for an item, or the acknowledgement."""
    return link.expect(
        "MISSION_REQUEST or MISSION_ACK",
        lambda m: m.get_type() in (*ITEM_REQUESTS, "MISSION_ACK"),
        10,
    )


def send_count(link: VehicleLink, count: int) -> None:
    """Opens an upload."""
    link.send(mavlink.MAVLink_mission_count_message(link.system_id, 1, count))


def send_item(link: VehicleLink, sequence: int, item: Item) -> None:
    """One item in answer to a request."""
    frame = mavlink.MAV_FRAME_GLOBAL if sequence == 0 else mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT
    link.send(
        mavlink.MAVLink_mission_item_int_message(
            link.system_id,
            1,
            sequence,
            frame,
            item.command,
            0,
            1,
            item.param1,
            item.param2,
            0,
            0,
            item.latitude,
            item.longitude,
            item.altitude_meters,
        )
    )
