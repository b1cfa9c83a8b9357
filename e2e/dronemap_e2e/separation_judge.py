"""Judges flights of the laboratory by true states of vehicles: apart, all waypoints served, all down in time.

Usage: separation_judge.py FOLDER... [--table FILE] [--breaching SHARE]

Each FOLDER holds `tracks.csv`, where each vehicle truly was every 0.1 s, and `facts.json`, what was to be
flown. Two vehicles breach when they are nearer than both distances at the same time, each of them in the air.
It imports nothing of the product, and nothing that Python does not have.
"""

import argparse
import csv
import json
import math
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from pathlib import Path
from typing import Any

HORIZONTAL_METRES, VERTICAL_METRES = 10.0, 5.0
# At that height above its pad or lower a vehicle takes off or lands, and is nobody's traffic.
AIRBORNE_METRES = 2.0
# What was passed so near, height included, was visited.
SERVED_METRES = 2.0
ON_THE_GROUND_METRES = 0.5
TIME_FACTOR, TIME_SLACK_SECONDS = 1.5, 30.0
# Places are written in billionths of a degree and in millimetres.
ROUNDING_METRES = 0.002
STEPS_PER_SECOND = 10
# WGS84.
EQUATOR_METRES, ECCENTRICITY_SQUARED = 6_378_137.0, 0.006_694_379_990_14

COLUMNS = ("seed", "second", "vehicle", "latitude", "longitude", "amsl", "above_pad", "armed")
TABLE = (
    *(
        "scenario",
        "seed",
        "moment",
        "mechanism",
        "result",
        "second",
        "pair",
        "horizontal",
        "vertical",
        "share",
    ),
    *("breaches", "unserved", "late", "factor"),
)
# So many of them say which flight it is.
KEYS = 4


@dataclass(frozen=True)
class Limits:
    """Distances of which one has to be kept, in metres."""

    horizontal: float = HORIZONTAL_METRES
    vertical: float = VERTICAL_METRES


@dataclass(frozen=True)
class State:
    """A vehicle at one step: degrees, metres above mean sea level, metres above its own pad."""

    step: int
    latitude: float
    longitude: float
    amsl: float
    above_pad: float
    armed: bool

    @property
    def second(self) -> float:
        return self.step / STEPS_PER_SECOND

    @property
    def airborne(self) -> bool:
        return self.above_pad > AIRBORNE_METRES

    @property
    def down(self) -> bool:
        return not self.armed and self.above_pad < ON_THE_GROUND_METRES


@dataclass(frozen=True)
class Approach:
    """Two vehicles at one step. `share`: 1 is just as far apart as they have to be, less is a breach."""

    share: float
    second: float
    pair: tuple[str, str]
    horizontal: float
    vertical: float

    @property
    def words(self) -> str:
        apart = f"{self.horizontal:.1f} m beside, {self.vertical:.1f} m above each other"
        return f"{self.pair[0]} and {self.pair[1]} at {self.second:.1f} s: {apart}"


NOBODY = Approach(math.inf, 0.0, ("", ""), math.inf, math.inf)


@dataclass
class Verdict:
    """Findings of one flight."""

    scenario: str
    seed: int
    # The second at which something came between; empty: nothing did.
    moment: str
    mechanism: str
    nearest: Approach
    # The first breach of each pair.
    breaches: list[Approach] = field(default_factory=list)
    unserved: list[str] = field(default_factory=list)
    late: list[str] = field(default_factory=list)
    # The longest time of an operation, as a multiple of what it needs alone; infinite: somebody is still up.
    factor: float = 0.0

    @property
    def result(self) -> str:
        found = {"breach": self.breaches, "unserved": self.unserved, "late": self.late}
        return "+".join(name for name, some in found.items() if some) or "ok"

    @property
    def words(self) -> str:
        moment = f" at {self.moment} s" if self.moment else ""
        said = [f"{self.scenario} seed {self.seed}{moment} ({self.mechanism}): {self.result}"]
        said += [f"breach, {one.words}" for one in self.breaches]
        if not self.breaches and self.nearest is not NOBODY:
            said.append(f"nearest, {self.nearest.words}")
        said += [f"unserved, {one}" for one in self.unserved]
        said += [f"late, {one}" for one in self.late]
        return "; ".join(said)

    def row(self) -> list[str]:
        first = min(self.breaches, key=lambda one: one.second, default=self.nearest)
        seen = self.nearest is not NOBODY
        return [
            *(self.scenario, str(self.seed), self.moment, self.mechanism, self.result),
            f"{first.second:.1f}" if seen else "",
            " and ".join(first.pair) if seen else "",
            *((f"{self.nearest.horizontal:.2f}", f"{self.nearest.vertical:.2f}") if seen else ("", "")),
            f"{self.nearest.share:.3f}" if seen else "",
            *(str(len(self.breaches)), str(len(self.unserved)), str(len(self.late)), f"{self.factor:.2f}"),
        ]


Tracks = dict[str, list[State]]


class FlightRefused(Exception):
    """A sentence about what cannot be judged."""


def read_tracks(lines: Iterable[str], seed: int) -> Tracks:
    """The states of each vehicle in the order of time."""
    rows = csv.DictReader(lines)
    if rows.fieldnames is None or tuple(rows.fieldnames) != COLUMNS:
        raise FlightRefused(f"tracks.csv needs the columns {','.join(COLUMNS)}, not {rows.fieldnames}.")
    tracks: Tracks = {}
    for row in rows:
        if int(row["seed"]) != seed:
            raise FlightRefused(f"tracks.csv is of seed {row['seed']}, facts.json of seed {seed}.")
        track = tracks.setdefault(row["vehicle"], [])
        step = round(float(row["second"]) * STEPS_PER_SECOND)
        if track and step != track[-1].step + 1:
            raise FlightRefused(f"{row['vehicle']} has no state 0.1 s before {row['second']} s.")
        latitude, longitude = float(row["latitude"]), float(row["longitude"])
        heights = float(row["amsl"]), float(row["above_pad"])
        track.append(State(step, latitude, longitude, *heights, row["armed"] == "1"))
    return tracks


def metres_apart(latitude: float, longitude: float, other: float, other_longitude: float) -> float:
    """Over the ground, between places that are no more than some kilometres apart."""
    middle = math.radians((latitude + other) / 2)
    bend = 1 - ECCENTRICITY_SQUARED * math.sin(middle) ** 2
    north = EQUATOR_METRES * (1 - ECCENTRICITY_SQUARED) / bend**1.5 * math.radians(other - latitude)
    across = EQUATOR_METRES / math.sqrt(bend) * math.cos(middle)
    return math.hypot(north, across * math.radians(other_longitude - longitude))


def find_breaches(tracks: Tracks, limits: Limits) -> tuple[Approach, list[Approach]]:
    """The nearest approach of all, and the first breach of each pair."""
    steps: dict[int, list[tuple[str, State]]] = {}
    for vehicle, track in tracks.items():
        for state in track:
            if state.airborne:
                steps.setdefault(state.step, []).append((vehicle, state))
    nearest, first = NOBODY, dict[tuple[str, str], Approach]()
    for step in sorted(steps):
        for (one, here), (other, there) in combinations(steps[step], 2):
            vertical = abs(here.amsl - there.amsl)
            if vertical / limits.vertical >= max(1.0, nearest.share):
                continue
            horizontal = metres_apart(here.latitude, here.longitude, there.latitude, there.longitude)
            share = max(horizontal / limits.horizontal, vertical / limits.vertical)
            found = Approach(share, here.second, (one, other), horizontal, vertical)
            if share < nearest.share:
                nearest = found
            beside = horizontal < limits.horizontal - ROUNDING_METRES
            if beside and vertical < limits.vertical - ROUNDING_METRES:
                first.setdefault((one, other), found)
    return nearest, list(first.values())


def unserved_waypoints(tracks: Tracks, operations: list[dict[str, Any]], served: float) -> list[str]:
    """Waypoints that no vehicle passed within `served` metres, of operations that owe all of theirs."""
    return [
        f"{operation['name']} waypoint {waypoint['name']} by {passed:.1f} m"
        for operation in operations
        if operation["required"]
        for waypoint in operation["waypoints"]
        if (passed := _nearest_pass(tracks.values(), waypoint)) > served + ROUNDING_METRES
    ]


def _nearest_pass(tracks: Iterable[Sequence[State]], waypoint: dict[str, Any]) -> float:
    at, least = (waypoint["latitude"], waypoint["longitude"]), math.inf
    for track in tracks:
        for state in track:
            vertical = abs(state.amsl - waypoint["amsl"])
            if vertical < least:
                least = min(least, math.hypot(metres_apart(state.latitude, state.longitude, *at), vertical))
    return least


def judge_times(tracks: Tracks, operations: list[dict[str, Any]]) -> tuple[list[str], float]:
    """Operations that are not down at all, everybody if too late, and that time by the undisturbed one.

    That is from the first beginning until the last operation would have been over, had each flown alone.
    """
    late: list[str] = []
    ends: list[float] = []
    for operation in operations:
        downs = {vehicle: down_since(tracks[vehicle]) for vehicle in operation["vehicles"]}
        up = [vehicle for vehicle, down in downs.items() if down is None]
        if up:
            late.append(f"{operation['name']}: {', '.join(up)} still up at the end")
        ends += [down for down in downs.values() if down is not None]
    if late:
        return late, math.inf
    timed = [one for one in operations if one["undisturbed"] is not None]
    if len(timed) < len(operations) or not ends:
        return [], 0.0
    first = min(one["begins"] for one in timed)
    alone = max(one["begins"] + one["undisturbed"] for one in timed) - first
    flown = max(ends) - first
    if flown > TIME_FACTOR * alone + TIME_SLACK_SECONDS:
        late.append(f"everybody down after {flown:.1f} s instead of {alone:.1f} s undisturbed")
    return late, flown / alone


def down_since(track: Sequence[State]) -> float | None:
    """When it was down for good; None: it is not."""
    if not track or not track[-1].down:
        return None
    up = next((state for state in reversed(track) if not state.down), None)
    return track[0].second if up is None else up.second + 1 / STEPS_PER_SECOND


def judge(tracks: Tracks, facts: dict[str, Any], limits: Limits) -> Verdict:
    missing = [
        vehicle
        for operation in facts["operations"]
        for vehicle in operation["vehicles"]
        if vehicle not in tracks
    ]
    if missing:
        raise FlightRefused(f"tracks.csv has no {', '.join(missing)}.")
    nearest, breaches = find_breaches(tracks, limits)
    late, factor = judge_times(tracks, facts["operations"])
    return Verdict(
        facts["scenario"],
        facts["seed"],
        f"{facts['moment']:.1f}" if "moment" in facts else "",
        "on" if facts["mechanism"] else "off",
        nearest,
        breaches,
        unserved_waypoints(tracks, facts["operations"], facts.get("served", SERVED_METRES)),
        late,
        factor,
    )


def judge_folder(folder: Path, limits: Limits) -> Verdict:
    facts = json.loads((folder / "facts.json").read_text(encoding="utf-8"))
    with (folder / "tracks.csv").open(encoding="utf-8", newline="") as lines:
        return judge(read_tracks(lines, facts["seed"]), facts, limits)


def write_rows(file: Path, verdicts: Sequence[Verdict]) -> None:
    """Adds them to those that stand there already; a flight that stands there is replaced."""
    rows: dict[tuple[str, ...], list[str]] = {}
    if file.exists():
        for line in file.read_text(encoding="utf-8").splitlines()[1:]:
            row = line.split("\t")
            rows[tuple(row[:KEYS])] = row
    for verdict in verdicts:
        rows[tuple(verdict.row()[:KEYS])] = verdict.row()
    ordered = sorted(rows.values(), key=lambda row: (row[0], row[3], int(row[1]), float(row[2] or 0)))
    file.parent.mkdir(parents=True, exist_ok=True)
    new = file.with_suffix(".new")
    new.write_text("\n".join("\t".join(row) for row in [TABLE, *ordered]) + "\n", encoding="utf-8")
    new.replace(file)


def passes(verdicts: Sequence[Verdict], breaching: float | None) -> bool:
    """All are ok; or, where nothing keeps them apart, at least that share breaches."""
    if breaching is None:
        return all(verdict.result == "ok" for verdict in verdicts)
    return sum(bool(verdict.breaches) for verdict in verdicts) >= breaching * len(verdicts)


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description="Judges flights by the true states of their vehicles.")
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--table", type=Path, help="adds a line for each flight to that file")
    parser.add_argument(
        "--breaching", type=float, help="passes if that share of the flights or more breaches"
    )
    parser.add_argument("--horizontal", type=float, default=HORIZONTAL_METRES)
    parser.add_argument("--vertical", type=float, default=VERTICAL_METRES)
    chosen = parser.parse_args(arguments)
    limits = Limits(chosen.horizontal, chosen.vertical)
    try:
        verdicts = [judge_folder(folder, limits) for folder in chosen.folders]
    except (FlightRefused, OSError, KeyError, ValueError) as refused:
        print(f"Not judged: {refused}", file=sys.stderr)
        return 2
    for verdict in verdicts:
        print(verdict.words)
    breaching = sum(bool(verdict.breaches) for verdict in verdicts)
    print(f"{len(verdicts)} flights, {breaching} with a breach")
    if chosen.table is not None:
        write_rows(chosen.table, verdicts)
    return 0 if passes(verdicts, chosen.breaching) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
