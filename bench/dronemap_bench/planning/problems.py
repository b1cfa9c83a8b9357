"""Benchmark instances as they are read from a folder, and as a solver gets them."""

import csv
import json
import math
import random
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

Point = tuple[float, float]
Tours = Sequence[Sequence[int]]

AIMS = {"min-max": "longest", "min-sum": "sum"}
METRICS = {"EUC_2D_REAL": "euclidean", "ATT": "att"}
UNPUBLISHED = "best found"


@dataclass(frozen=True)
class Problem:
    """Tours from depots (one for each drone) over waypoints and back."""

    metric: str
    aim: str
    depots: tuple[Point, ...]
    waypoints: tuple[Point, ...]

    def text(self) -> str:
        lines = [f"metric {self.metric}", f"aim {self.aim}"]
        lines += [f"depot {x!r} {y!r}" for x, y in self.depots]
        lines += [f"waypoint {x!r} {y!r}" for x, y in self.waypoints]
        return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class Row:
    """One instance with an aim, and the best value known for it."""

    name: str
    best: float
    published: bool
    problem: Problem

    @property
    def size(self) -> int:
        return len(self.problem.waypoints)


def read(folder: Path) -> list[Row]:
    """All rows of `index.csv`."""
    with (folder / "index.csv").open(newline="") as file:
        return [_row(folder, fields) for fields in csv.DictReader(file)]


def _row(folder: Path, fields: dict[str, str]) -> Row:
    coordinates = json.loads((folder / fields["file"]).read_text())
    drones = int(fields["m_drones"])
    depots: list[Point] = []
    for depot in coordinates["depots"]:
        depots += [(float(depot["x"]), float(depot["y"]))] * int(depot.get("drones", drones))
    waypoints = tuple((float(x), float(y)) for x, y in coordinates["waypoints"])
    if len(depots) != drones or len(waypoints) != int(fields["n_waypoints"]):
        raise ValueError(f"{fields['instance']}: its file does not fit its row in index.csv")
    problem = Problem(METRICS[fields["edge_weight"]], AIMS[fields["objective"]], tuple(depots), waypoints)
    published = not fields["source"].startswith(UNPUBLISHED)
    return Row(fields["instance"], float(fields["best_known"]), published, problem)


@dataclass(frozen=True)
class Moved:
    """A problem rotated, scaled, shifted and with its waypoints in another order: another one to a solver,
    the same one to a judge."""

    problem: Problem
    numbers: tuple[int, ...]
    """What each waypoint's number was."""

    def back(self, tours: Tours) -> list[list[int]]:
        """Tours of the moved problem as those of the original."""
        return [[self.numbers[waypoint] for waypoint in tour] for tour in tours]


def moved(problem: Problem, seed: int) -> Moved:
    """ATT rounds, so that it stands quarter turns only."""
    chance = random.Random(seed)
    if problem.metric == "att":
        angle, scale = chance.randrange(1, 4) * math.pi / 2, 1.0
        cosine, sine = float(round(math.cos(angle))), float(round(math.sin(angle)))
        shift = (float(chance.randrange(1000)), float(chance.randrange(1000)))
    else:
        angle, scale = chance.uniform(0.2, 2 * math.pi - 0.2), chance.uniform(0.2, 8)
        cosine, sine = math.cos(angle), math.sin(angle)
        shift = (chance.uniform(-500, 500), chance.uniform(-500, 500))

    def move(point: Point) -> Point:
        x, y = point
        return scale * (cosine * x - sine * y) + shift[0], scale * (sine * x + cosine * y) + shift[1]

    numbers = list(range(len(problem.waypoints)))
    chance.shuffle(numbers)
    waypoints = tuple(move(problem.waypoints[number]) for number in numbers)
    depots = tuple(move(depot) for depot in problem.depots)
    return Moved(Problem(problem.metric, problem.aim, depots, waypoints), tuple(numbers))
