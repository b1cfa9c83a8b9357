"""The flight that every face must be able to fly, and its judge, who sees only the wire."""

import math
from dataclasses import dataclass
from datetime import datetime

from .api import Api, Json
from .message_recorder import MessageLog, RecordedMessage

EARTH_RADIUS_METERS = 6_371_008.8
ARMED = 0x80
COPTER_AUTO = 3
COPTER_RTL = 6


@dataclass(frozen=True)
class Point:
    latitude: float
    longitude: float
    altitude: float

    def metres_to(self, latitude: float, longitude: float) -> float:
        north = math.radians(latitude - self.latitude) * EARTH_RADIUS_METERS
        east = math.radians(longitude - self.longitude) * EARTH_RADIUS_METERS
        return math.hypot(north, east * math.cos(math.radians(self.latitude)))


def triangle(home: Json, altitude: float = 8.0, side: float = 20.0) -> list[Point]:
    """Three waypoints around a home, some tens of metres apart."""
    per_degree = math.radians(1) * EARTH_RADIUS_METERS
    east = per_degree * math.cos(math.radians(home["latitude"]))
    return [
        Point(home["latitude"] + dn * side / per_degree, home["longitude"] + de * side / east, altitude)
        for dn, de in ((1, 0), (1, 1), (0, 1))
    ]


def items(points: list[Point]) -> list[Json]:
    return [
        {"type": "waypoint", "latitude": p.latitude, "longitude": p.longitude, "altitude": p.altitude}
        for p in points
    ]


def judge(wire: MessageLog, points: list[Point], take_off_altitude: float, tolerance: float = 2.0) -> None:
    """Asserts by its messages that it armed, climbed, passed each waypoint, returned and disarmed."""
    track = [h for h in wire.messages("GLOBAL_POSITION_INT", up=True)]
    beats = [h for h in wire.messages("HEARTBEAT", up=True) if h.message.get_srcComponent() == 1]
    armed = [bool(h.message.base_mode & ARMED) for h in beats]
    assert True in armed, "it was never armed"
    assert not armed[-1], "it is still armed"
    assert max(h.message.relative_alt for h in track) / 1000 >= take_off_altitude - 1, "it never climbed"
    modes = [h.message.custom_mode for h in beats]
    assert COPTER_AUTO in modes, "it never flew its mission"
    assert COPTER_RTL in modes, "it never returned"
    assert modes.index(COPTER_AUTO) < len(modes) - 1 - modes[::-1].index(COPTER_RTL)
    start = 0
    for number, point in enumerate(points, 1):
        start = _passed(track, start, point, number, tolerance)
    assert track[-1].message.relative_alt / 1000 < 1, "it did not land"


def _passed(track: list[RecordedMessage], start: int, point: Point, number: int, tolerance: float) -> int:
    """Index in the track at which it came within the tolerance of the point, at the point's height."""
    nearest = math.inf
    for index in range(start, len(track)):
        seen = track[index].message
        away = point.metres_to(seen.lat / 1e7, seen.lon / 1e7)
        if abs(seen.relative_alt / 1000 - point.altitude) <= tolerance:
            nearest = min(nearest, away)
            if away <= tolerance:
                return index
    raise AssertionError(f"waypoint {number} was passed at {nearest:.1f} m, not within {tolerance} m")


def seconds_of(iso: str) -> float:
    return datetime.fromisoformat(iso.replace("Z", "+00:00")).timestamp()


def flight_of(api: Api, drone: str, state: str) -> Json | None:
    """The newest flight that is remembered of the drone, when it is in that state."""
    flights = api.get(f"/flights?drone={drone}")["flights"]
    return flights[0] if flights and flights[0]["state"] == state else None
