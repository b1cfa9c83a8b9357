"""Measures how near vehicles come to each other in the air, by their own reports on the wire."""

import math
from dataclasses import dataclass
from itertools import combinations

from .datagram_recorder import Log

BESIDE_METRES, ABOVE_METRES = 10.0, 5.0
IN_THE_AIR_METRES = 2.0
EVERY_SECONDS = 0.25
METRES_PER_DEGREE = 111_195.0


@dataclass(frozen=True)
class Fix:
    """Monotonic seconds, degrees, and metres above the sea and above home."""

    at: float
    latitude: float
    longitude: float
    amsl: float
    height: float


@dataclass(frozen=True)
class Nearest:
    """`share`: 1 is just as far apart as they have to be, 10 m beside or 5 m above each other."""

    share: float
    words: str


def fixes(log: Log, since: float) -> list[Fix]:
    return [
        Fix(
            timed.at,
            timed.message.lat / 1e7,
            timed.message.lon / 1e7,
            timed.message.alt / 1000,
            timed.message.relative_alt / 1000,
        )
        for timed in log.up
        if timed.kind == "GLOBAL_POSITION_INT" and timed.at >= since
    ]


def nearest(tracks: dict[int, list[Fix]], since: float, until: float) -> Nearest:
    """The nearest two that are in the air at the same moment."""
    found = Nearest(math.inf, "no two were in the air")
    moment = since
    newest = dict.fromkeys(tracks, 0)
    while moment < until:
        now: dict[int, Fix] = {}
        for vehicle, track in tracks.items():
            at = newest[vehicle]
            while at + 1 < len(track) and track[at + 1].at <= moment:
                at += 1
            newest[vehicle] = at
            if track and track[at].height > IN_THE_AIR_METRES:
                now[vehicle] = track[at]
        for one, other in combinations(now, 2):
            found = min(found, _between(one, other, now[one], now[other]), key=lambda seen: seen.share)
        moment += EVERY_SECONDS
    return found


def _between(one: int, other: int, here: Fix, there: Fix) -> Nearest:
    north = (there.latitude - here.latitude) * METRES_PER_DEGREE
    across = METRES_PER_DEGREE * math.cos(math.radians(here.latitude))
    beside = math.hypot(north, (there.longitude - here.longitude) * across)
    above = abs(here.amsl - there.amsl)
    share = max(beside / BESIDE_METRES, above / ABOVE_METRES)
    return Nearest(share, f"{one} and {other}: {beside:.1f} m beside, {above:.1f} m above each other")
