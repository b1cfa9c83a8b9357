"""Ways between places, in metres."""

import math

_EARTH_METERS = 6_371_000.0


def meters_between(latitude: float, longitude: float, to_latitude: float, to_longitude: float) -> float:
    """Over ground, along a great circle."""
    a, b = math.radians(latitude), math.radians(to_latitude)
    half_up = math.sin((b - a) / 2) ** 2
    half_along = math.sin(math.radians(to_longitude - longitude) / 2) ** 2
    return 2 * _EARTH_METERS * math.asin(math.sqrt(min(1.0, half_up + math.cos(a) * math.cos(b) * half_along)))


def offset(latitude: float, longitude: float, north: float = 0.0, east: float = 0.0) -> tuple[float, float]:
    """Latitude and longitude of the place so many metres north and east of another; for some kilometres."""
    up = math.degrees(north / _EARTH_METERS)
    along = math.degrees(east / (_EARTH_METERS * math.cos(math.radians(latitude))))
    return latitude + up, longitude + along
