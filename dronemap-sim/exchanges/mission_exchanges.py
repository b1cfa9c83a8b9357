"""Exchanges about missions, on the ground and in flight."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import arm, climb_to, disarmed, ready, start
from missions import Item, clear, download, fly_square, send_count, send_out_of_turn, upload, upload_until
from vehicle_link import VehicleLink


def mission_upload(link: VehicleLink) -> None:
    """Six items up, read back, again over the first, one item back, cleared."""
    ready(link)
    start(link)
    items = fly_square(link.position)
    upload(link, items)
    download(link)
    upload(link, items[:4])
    download(link)
    clear(link)
    download(link)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(2)


def mission_upload_refused(link: VehicleLink) -> None:
    """An unknown item, a latitude of 95 degrees, a wrong order, odd counts and requests, an upload given up."""
    ready(link)
    start(link)
    good = fly_square(link.position)
    upload(link, [*good[:2], Item(31000, 0, 0, 10), *good[3:]])
    download(link)
    upload(link, [*good[:2], Item(mavlink.MAV_CMD_NAV_WAYPOINT, 950_000_000, 0, 10), *good[3:]])
    download(link)
    send_out_of_turn(link, good)
    link.pump_for(1)
    link.send(mavlink.MAVLink_mission_request_int_message(link.system_id, 1, 40))
    link.pump_for(1)
    link.send(mavlink.MAVLink_mission_request_message(link.system_id, 1, 1))
    link.pump_for(1)
    for count in (0, 5000):
        send_count(link, count)
        link.pump_for(1)
    upload_until(link, good, skipping=2)
    link.pump_for(12)
    download(link)


def mission_flight(link: VehicleLink) -> None:
    """Armed on the ground in GUIDED, AUTO, MISSION_START: take-off, three waypoints, RTL, landed, disarmed."""
    ready(link)
    upload(link, fly_square(link.position))
    start(link)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    disarmed(link, 240)


def mission_from_the_air(link: VehicleLink) -> None:
    """AUTO chosen while hovering in GUIDED; paused and continued; jump to an item; the last item is a waypoint."""
    ready(link)
    upload(link, fly_square(link.position)[:5])
    climb_to(link, 20)
    start(link)
    link.set_mode_and_acknowledge("AUTO")
    link.wait_until("item 2", lambda: link.last["MISSION_CURRENT"].seq == 2, 30)
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.pump_for(6)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 1)
    link.pump_for(2)
    link.send(mavlink.MAVLink_mission_set_current_message(link.system_id, 1, 4))
    link.wait_until("item 4 reached", lambda: "MISSION_ITEM_REACHED" in link.last and reached(link) == 4, 90)
    link.pump_for(10)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MISSION_CURRENT, 2)
    link.pump_for(4)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.pump_for(4)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(4)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(3)


def reached(link: VehicleLink) -> int:
    """The item reached last."""
    return int(link.last["MISSION_ITEM_REACHED"].seq)


def mission_cleared_in_flight(link: VehicleLink) -> None:
    """MISSION_CLEAR_ALL while AUTO flies."""
    ready(link)
    upload(link, fly_square(link.position)[:5])
    climb_to(link, 20)
    link.set_mode_and_acknowledge("AUTO")
    link.wait_until("item 2", lambda: link.last["MISSION_CURRENT"].seq == 2, 30)
    start(link)
    clear(link)
    link.pump_for(10)
    download(link)
