"""Missions under way that lose a drone: how soon there is another plan, and how good it is."""

import json
import statistics
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .runs import CLASSES, RunError

JAVA = ["java", "-Xmx2g", "-cp", CLASSES, "org.dronemap.bench.planning.loss.DroneLossBenchmark"]


@dataclass(frozen=True)
class Setup:
    cases: int
    waypoints: int
    drones: int
    budget_ms: float
    solve_seconds: float
    """Of the search that each plan is held against; 0: none."""

    def arguments(self) -> list[str]:
        return [
            str(word)
            for word in (self.cases, self.waypoints, self.drones, self.budget_ms, self.solve_seconds)
        ]


@dataclass(frozen=True)
class Case:
    at_once_ms: float
    better_ms: float
    faults: int
    at_once_cost: float
    better_cost: float
    long_cost: float
    changed: int

    @property
    def gap_percent(self) -> float:
        """Gap of the better plan to the long search's, or to itself where that was worse."""
        return 100 * (self.better_cost / min(self.long_cost, self.better_cost) - 1)


def parse(lines: list[str]) -> list[Case]:
    return [_case(columns) for columns in map(str.split, lines) if columns and columns[0] == "case"]


def _case(columns: list[str]) -> Case:
    at_once, better, faults, *costs, changed = columns[1:]
    once_cost, better_cost, long_cost = map(float, costs)
    return Case(float(at_once), float(better), int(faults), once_cost, better_cost, long_cost, int(changed))


def run(setup: Setup) -> list[Case]:
    done = subprocess.run([*JAVA, *setup.arguments()], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RunError(f"re-planning failed:\n{done.stderr.strip()[-2000:]}")
    return parse(done.stdout.splitlines())


def table(setup: Setup, cases: list[Case]) -> str:
    rows = [
        ("a plan at once, ms", [case.at_once_ms for case in cases]),
        (f"a better plan ({setup.budget_ms:g} ms), ms", [case.better_ms for case in cases]),
        (f"from a search of {setup.solve_seconds:g} s, %", [case.gap_percent for case in cases]),
        ("drones that change", [float(case.changed) for case in cases]),
    ]
    lines = [
        f"{len(cases)} random missions of {setup.waypoints} waypoints and {setup.drones} drones lose one; "
        f"{sum(case.faults for case in cases)} faults.",
        "",
        "| | mean | median | 95 % | most |",
        "| --- | --- | --- | --- | --- |",
    ]
    for what, values in rows:
        cells = (statistics.fmean(values), statistics.median(values), percentile(values, 95), max(values))
        lines.append(f"| {what} | " + " | ".join(f"{cell:.2f}" for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def percentile(values: list[float], percent: int) -> float:
    """The least value that so many percent are not above."""
    return sorted(values)[max(0, -(-percent * len(values) // 100) - 1)]


def write(folder: Path, name: str, about: dict[str, Any], setup: Setup, cases: list[Case]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about, "setup": vars(setup), "cases": [vars(case) for case in cases]}
    (folder / f"{name}.json").write_text(json.dumps(whole, separators=(",", ":")) + "\n")
    (folder / f"{name}.md").write_text(table(setup, cases))
