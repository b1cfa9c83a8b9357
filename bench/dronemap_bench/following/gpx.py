"""Tracks that were recorded: GPX into seconds and metres."""

import datetime
import math
import xml.etree.ElementTree as ElementTree
from pathlib import Path

METRES_PER_DEGREE = 111_195.0
# Whoever seems faster was not where the receiver said.
FASTEST_METRES_PER_SECOND = 25.0


def points(text: str) -> list[tuple[float, float, float]]:
    """Seconds, metres east and metres north of the first point, without leaps and times that do not go on."""
    found: list[tuple[float, float, float]] = []
    origin = None
    for point in ElementTree.fromstring(text).iter():
        if point.tag.rpartition("}")[2] != "trkpt":
            continue
        time = next((child.text for child in point if child.tag.rpartition("}")[2] == "time"), None)
        if not time:
            continue
        at = datetime.datetime.fromisoformat(time.strip().replace("Z", "+00:00"))
        latitude, longitude = float(point.attrib["lat"]), float(point.attrib["lon"])
        origin = origin or (at, latitude, longitude)
        seconds = (at - origin[0]).total_seconds()
        east = (longitude - origin[2]) * METRES_PER_DEGREE * math.cos(math.radians(origin[1]))
        north = (latitude - origin[1]) * METRES_PER_DEGREE
        if not found or _reaches(found[-1], (seconds, east, north)):
            found.append((seconds, east, north))
    return found


def _reaches(before: tuple[float, float, float], now: tuple[float, float, float]) -> bool:
    seconds = now[0] - before[0]
    return seconds > 0 and math.dist(before[1:], now[1:]) <= FASTEST_METRES_PER_SECOND * seconds


def written(file: Path, folder: Path) -> str:
    """Writes a track for the trials; returns the argument that names it."""
    track = points(file.read_text())
    if len(track) < 2:
        raise SystemExit(f"{file} has no track with times.")
    lines = folder / f"{file.stem}.txt"
    lines.write_text("".join(f"{seconds} {east} {north}\n" for seconds, east, north in track))
    name = "".join(letter for letter in file.stem if letter.isalnum() or letter in " -_")
    return f"{name or 'track'}={lines}"
