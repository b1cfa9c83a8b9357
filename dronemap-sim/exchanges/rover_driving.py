"""Steps that the exchanges with an ArduRover share: getting ready, stopping, a round to drive."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import DEGREES_E7_PER_METER_NORTH, arm, ready, start
from missions import Item
from vehicle_link import VehicleLink

WAYPOINT = int(mavlink.MAV_CMD_NAV_WAYPOINT)


def ready_to_drive(link: VehicleLink, mode: str = "GUIDED") -> None:
    """Ready, the exchange begins, the mode is chosen, armed."""
    ready(link)
    start(link)
    link.set_mode_and_acknowledge(mode)
    link.wait_until(mode, lambda: link.mode == mode, 5)
    arm(link)
    link.pump_for(2)


def stopped(link: VehicleLink, seconds: float = 60) -> None:
    """Wait until it has set off and stands again."""
    link.wait_until("set off", lambda: speed(link) > 0.5, 10)
    link.wait_until("stopped", lambda: speed(link) < 0.1, seconds)
    link.pump_for(3)


def speed(link: VehicleLink) -> float:
    """Metres a second over ground."""
    return float(link.last["VFR_HUD"].groundspeed)


def drive(home: tuple[int, int]) -> list[Item]:
    """Five items: home, then three waypoints 25 m apart, at the second of which it waits for 3 s, and one at home."""
    latitude, longitude = home
    north = round(25 * DEGREES_E7_PER_METER_NORTH)
    east = round(north * 1.226)  # at the recording's latitude of 35.4 degrees
    return [
        Item(WAYPOINT, latitude, longitude, 0),
        Item(WAYPOINT, latitude + north, longitude, 0),
        Item(WAYPOINT, latitude + north, longitude + east, 0, param1=3),
        Item(WAYPOINT, latitude, longitude + east, 0),
        Item(WAYPOINT, latitude, longitude, 0),
    ]
