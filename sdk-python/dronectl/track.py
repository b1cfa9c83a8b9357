"""Ways in files: where somebody was, and after how many seconds."""

import csv
import io
import math
import xml.etree.ElementTree as Tree
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime
from itertools import pairwise
from pathlib import Path

from dronectl.failure import BadFile
from dronectl.reading import content
from dronemap import meters_between


@dataclass(frozen=True)
class Place:
    """Where it is, degrees; how fast in m/s, and to where, degrees from true north."""

    latitude: float
    longitude: float
    speed: float
    course: float


@dataclass(frozen=True)
class Track:
    """A way; `seconds` rise from 0."""

    seconds: tuple[float, ...]
    places: tuple[tuple[float, float], ...]

    @property
    def length(self) -> float:
        """Seconds from its beginning to its end."""
        return self.seconds[-1]

    def at(self, second: float) -> Place:
        """Between two points, straight from one to the other; before and after, where it begins and ends."""
        last = len(self.seconds) - 1
        index = max(0, min(last - 1, next((i for i in range(last) if second < self.seconds[i + 1]), last - 1)))
        (latitude, longitude), (to_latitude, to_longitude) = self.places[index], self.places[index + 1]
        span = self.seconds[index + 1] - self.seconds[index]
        share = max(0.0, min(1.0, (second - self.seconds[index]) / span))
        moves = 0.0 <= second < self.length
        return Place(
            latitude + share * (to_latitude - latitude),
            longitude + share * (to_longitude - longitude),
            meters_between(latitude, longitude, to_latitude, to_longitude) / span if moves else 0.0,
            _course(latitude, longitude, to_latitude, to_longitude),
        )


def read_track(file: Path, speed: float) -> Track:
    """GPX, or a CSV with the columns latitude, longitude and perhaps seconds; without times, at `speed` m/s."""
    raw = content(file)
    found = _gpx(file, raw) if raw.lstrip().startswith(b"<") else _csv(file, raw)
    places = [(latitude, longitude) for latitude, longitude, _ in found]
    if not all(-90 <= latitude <= 90 and -180 <= longitude <= 180 for latitude, longitude in places):
        raise BadFile(f"{file}: latitudes must be from -90 to 90 and longitudes from -180 to 180 degrees.")
    seconds = [second for _, _, second in found]
    if not places:
        raise _no_way(file)
    if any(second is None for second in seconds):
        return _joined(file, _paced(places, speed), places)
    begin = seconds[0] or 0.0
    return _joined(file, [(second or 0.0) - begin for second in seconds], places)


def _joined(file: Path, seconds: Iterable[float], places: list[tuple[float, float]]) -> Track:
    times: list[float] = []
    kept: list[tuple[float, float]] = []
    for second, place in zip(seconds, places, strict=True):
        if times and second < times[-1]:
            raise BadFile(f"{file}: its times do not rise.")
        if not times or second > times[-1]:
            times.append(second)
            kept.append(place)
    if len(times) < 2:
        raise _no_way(file)
    return Track(tuple(times), tuple(kept))


def _no_way(file: Path) -> BadFile:
    return BadFile(f"{file} has no way: it needs two points at least that lie apart.")


def _paced(places: list[tuple[float, float]], speed: float) -> list[float]:
    seconds = [0.0]
    for before, after in pairwise(places):
        seconds.append(seconds[-1] + meters_between(*before, *after) / speed)
    return seconds[: len(places)]


def _gpx(file: Path, raw: bytes) -> list[tuple[float, float, float | None]]:
    try:
        points = [point for point in Tree.fromstring(raw).iter() if point.tag.rsplit("}", 1)[-1] == "trkpt"]
        return [(float(point.attrib["lat"]), float(point.attrib["lon"]), _time(point)) for point in points]
    except (Tree.ParseError, KeyError, ValueError) as e:
        raise BadFile(f"{file} is no GPX that can be read: {e}") from e


def _time(point: Tree.Element) -> float | None:
    for child in point:
        if child.tag.rsplit("}", 1)[-1] == "time" and child.text:
            return datetime.fromisoformat(child.text.strip()).timestamp()
    return None


def _csv(file: Path, raw: bytes) -> list[tuple[float, float, float | None]]:
    rows = csv.DictReader(io.StringIO(raw.decode("utf-8-sig", errors="replace")), skipinitialspace=True)
    if not {"latitude", "longitude"} <= set(rows.fieldnames or ()):
        raise BadFile(f"{file} must be GPX, or CSV whose first line names latitude, longitude and perhaps seconds.")
    try:
        return [
            (float(row["latitude"]), float(row["longitude"]), float(row["seconds"]) if row.get("seconds") else None)
            for row in rows
        ]
    except (TypeError, ValueError) as e:
        raise BadFile(f"{file}: line {rows.line_num} cannot be read: {e}") from e


def _course(latitude: float, longitude: float, to_latitude: float, to_longitude: float) -> float:
    a, b = math.radians(latitude), math.radians(to_latitude)
    along = math.radians(to_longitude - longitude)
    east = math.sin(along) * math.cos(b)
    north = math.cos(a) * math.sin(b) - math.sin(a) * math.cos(b) * math.cos(along)
    return math.degrees(math.atan2(east, north)) % 360
