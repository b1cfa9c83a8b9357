"""Judges tours from the coordinates alone; shares nothing with what made them."""

import math
from collections import Counter
from collections.abc import Sequence

from .problems import Point, Problem, Tours


def faults(problem: Problem, tours: Tours) -> list[str]:
    """Sentences; none when every waypoint is visited once and, where the sum counts, every drone flies."""
    found = []
    if len(tours) != len(problem.depots):
        found.append(f"{len(tours)} tours for {len(problem.depots)} drones")
    visits = Counter(waypoint for tour in tours for waypoint in tour)
    known = range(len(problem.waypoints))
    found += [f"there is no waypoint {waypoint}" for waypoint in sorted(visits) if waypoint not in known]
    found += [f"waypoint {w} is visited {visits[w]} times" for w in known if visits[w] != 1]
    if problem.aim == "sum":
        found += [f"drone {number} stays idle" for number, tour in enumerate(tours) if not tour]
    return found


def value(problem: Problem, tours: Tours) -> float:
    """Value of the tours by the problem's aim; each begins and ends at its drone's depot."""
    lengths = [_length(problem, depot, tour) for depot, tour in zip(problem.depots, tours, strict=True)]
    return max(lengths) if problem.aim == "longest" else math.fsum(lengths)


def _length(problem: Problem, depot: Point, tour: Sequence[int]) -> float:
    places = [depot, *(problem.waypoints[waypoint] for waypoint in tour), depot]
    legs = zip(places, places[1:], strict=False)
    return math.fsum(_distance(problem.metric, one, other) for one, other in legs)


def _distance(metric: str, one: Point, other: Point) -> float:
    if metric == "euclidean":
        return math.dist(one, other)
    return float(math.ceil(math.sqrt(((one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2) / 10)))
