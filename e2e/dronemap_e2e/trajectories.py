"""Judges a mission run by the vehicles' positions alone: visits, fences and distances."""

import bisect
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

# Copters slow down where they are to be, and pass everything else.
NEAR_METRES = 2.5
NEAR_HEIGHT_METRES = 1.5
SLOW_METRES_PER_SECOND = 2.6
LEFT_METRES = 8.0
AIRBORNE_METRES = 1.0
LEAST_HORIZONTAL = 10.0
LEAST_VERTICAL = 5.0
# Heights wander by so much where layers are exactly as far apart as they must be.
WANDER_METRES = 0.6
STRIDE_SECONDS = 0.1


@dataclass(frozen=True)
class Fix:
    """A position of one vehicle: seconds of a common clock, metres from one place, and over its home."""

    seconds: float
    east: float
    north: float
    up: float
    above_home: float


@dataclass(frozen=True)
class Spot:
    """A waypoint."""

    name: str
    east: float
    north: float
    up: float


@dataclass(frozen=True)
class Visit:
    """`at_start`: it had not left the place where it took off, and may only be on its way somewhere else."""

    waypoint: str
    vehicle: int
    seconds: float
    at_start: bool = False


@dataclass(frozen=True)
class Disc:
    """A keep-out up to a height; `top` infinite: at all heights."""

    name: str
    east: float
    north: float
    radius: float
    top: float


@dataclass(frozen=True)
class Nearest:
    """The nearest approach of two vehicles in the air that height did not keep apart."""

    metres: float
    height: float
    vehicles: tuple[int, int]
    seconds: float


class Track:
    """One vehicle's way, up to where it counts for nothing any more (when it fell)."""

    def __init__(self, fixes: Sequence[Fix], ends: float = math.inf) -> None:
        self.fixes = [fix for fix in fixes if fix.seconds <= ends]
        self._seconds = [fix.seconds for fix in self.fixes]

    def at(self, seconds: float) -> Fix | None:
        """Straight on between two reports; None before the first and after the last."""
        after = bisect.bisect_left(self._seconds, seconds)
        if after == len(self.fixes) or (after == 0 and self._seconds[0] > seconds):
            return None
        later = self.fixes[after]
        if after == 0:
            return later
        earlier = self.fixes[after - 1]
        span = later.seconds - earlier.seconds
        share = (seconds - earlier.seconds) / span if span else 0.0

        def between(one: float, other: float) -> float:
            return one + share * (other - one)

        return Fix(
            seconds,
            between(earlier.east, later.east),
            between(earlier.north, later.north),
            between(earlier.up, later.up),
            between(earlier.above_home, later.above_home),
        )

    def speeds(self) -> Iterator[tuple[Fix, float]]:
        """Each report with the speed since the one before, over ground."""
        for before, now in zip(self.fixes, self.fixes[1:], strict=False):
            span = now.seconds - before.seconds
            if span > 0:
                yield now, math.hypot(now.east - before.east, now.north - before.north) / span


def visits(tracks: dict[int, Track], spots: Sequence[Spot]) -> list[Visit]:
    """Visits of waypoints at which a vehicle slowed down; one until it has gone away again."""
    found = []
    for vehicle, track in tracks.items():
        there: set[str] = set()
        start = next((fix for fix in track.fixes if fix.above_home > AIRBORNE_METRES), None)
        at_start = start is not None
        for fix, speed in track.speeds():
            if start is not None and fix.seconds > start.seconds:
                moved = math.hypot(fix.east - start.east, fix.north - start.north)
                at_start = at_start and moved <= LEFT_METRES
            for spot in spots:
                away = math.hypot(fix.east - spot.east, fix.north - spot.north)
                if away > LEFT_METRES:
                    there.discard(spot.name)
                elif (
                    spot.name not in there
                    and away <= NEAR_METRES
                    and abs(fix.up - spot.up) <= NEAR_HEIGHT_METRES
                    and speed <= SLOW_METRES_PER_SECOND
                ):
                    there.add(spot.name)
                    found.append(Visit(spot.name, vehicle, fix.seconds, at_start))
    return sorted(found, key=lambda visit: visit.seconds)


def crossings(tracks: dict[int, Track], discs: Sequence[Disc]) -> list[tuple[int, str, float]]:
    """Vehicles in the air within a keep-out: who, which, when first."""
    found = []
    for vehicle, track in tracks.items():
        for disc in discs:
            for fix in _strides(track):
                inside = math.hypot(fix.east - disc.east, fix.north - disc.north) < disc.radius
                if inside and fix.up < disc.top and fix.above_home > AIRBORNE_METRES:
                    found.append((vehicle, disc.name, fix.seconds))
                    break
    return found


def _strides(track: Track) -> Iterator[Fix]:
    if not track.fixes:
        return
    seconds, end = track.fixes[0].seconds, track.fixes[-1].seconds
    while seconds <= end:
        fix = track.at(seconds)
        if fix is not None:
            yield fix
        seconds += STRIDE_SECONDS


def nearest(tracks: dict[int, Track]) -> Nearest | None:
    """The nearest pair that height did not keep apart; None: there was none."""
    least: Nearest | None = None
    starts = [track.fixes[0].seconds for track in tracks.values() if track.fixes]
    ends = [track.fixes[-1].seconds for track in tracks.values() if track.fixes]
    seconds, end = min(starts), max(ends)
    while seconds <= end:
        up = [
            (vehicle, fix)
            for vehicle, track in tracks.items()
            if (fix := track.at(seconds)) is not None and fix.above_home > AIRBORNE_METRES
        ]
        for number, (one, here) in enumerate(up):
            for other, there in up[number + 1 :]:
                height = abs(here.up - there.up)
                metres = math.hypot(here.east - there.east, here.north - there.north)
                if height < LEAST_VERTICAL - WANDER_METRES and (least is None or metres < least.metres):
                    least = Nearest(metres, height, (one, other), seconds)
        seconds += STRIDE_SECONDS
    return least


def doubles(found: Sequence[Visit]) -> dict[str, list[Visit]]:
    """The waypoints that were visited more than once."""
    by_waypoint: dict[str, list[Visit]] = {}
    for visit in found:
        by_waypoint.setdefault(visit.waypoint, []).append(visit)
    return {waypoint: some for waypoint, some in by_waypoint.items() if len(some) > 1}
