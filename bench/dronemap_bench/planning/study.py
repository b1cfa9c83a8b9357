"""Random runs with random failures in virtual time: what was served, how late, how soon others took over."""

import json
import math
import statistics
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from ..report import COLOURS
from .losses import percentile
from .runs import CLASSES, RunError

JAVA = ["java", "-Xmx2g", "-cp", CLASSES, "org.dronemap.cognitive.operation.run.RunStudy"]
WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 380, 250, 52, 34, 300, 170
TICKS = 5


@dataclass(frozen=True)
class Run:
    """One mission, flown without and with failures."""

    seed: int
    drones: int
    lost: int
    waypoints: int
    visited: int
    replans: int
    somebody_left: bool
    calm_seconds: float
    seconds: float
    closest_metres: float
    waits: tuple[float, ...]
    """How long each waypoint that had lost its drone was on board of nobody, in seconds."""

    @property
    def ratio(self) -> float:
        return self.seconds / self.calm_seconds


@dataclass(frozen=True)
class Study:
    runs: list[Run]
    broken: list[str]
    """What must hold and did not, with the seed."""


def parse(lines: Iterator[str]) -> Study:
    runs, broken = [], []
    for line in lines:
        kind, _, rest = line.strip().partition(" ")
        if kind == "run":
            runs.append(_run(rest.split()))
        elif kind == "broken":
            broken.append(rest)
        if kind and len(runs) % 100 == 0:
            print(f"{len(runs)} runs", file=sys.stderr)
    return Study(sorted(runs, key=lambda run: run.seed), sorted(broken))


def _run(columns: list[str]) -> Run:
    seed, drones, lost, waypoints, visited, replans = map(int, columns[:6])
    calm, seconds, closest = map(float, columns[7:10])
    left = columns[6] == "true"
    waits = tuple(json.loads(columns[10]))
    return Run(seed, drones, lost, waypoints, visited, replans, left, calm, seconds, closest, waits)


def run(first: int, count: int) -> Study:
    java = subprocess.Popen([*JAVA, str(first), str(count)], stdout=subprocess.PIPE, text=True)
    assert java.stdout is not None
    study = parse(iter(java.stdout))
    if java.wait() != 0 or len(study.runs) + len(study.broken) != count:
        raise RunError(f"the study ended early, with {java.returncode}")
    return study


def table(study: Study) -> str:
    runs = study.runs
    places = sum(run.waypoints for run in runs)
    waits = [wait for run in runs for wait in run.waits]
    unserved = [run for run in runs if run.visited < run.waypoints]
    rows = [
        ("time of the run against the one without failures", [run.ratio for run in runs]),
        ("an orphan's wait for a drone that has it on board, s", waits),
        ("closest to each other, m", [run.closest_metres for run in runs if run.closest_metres < 1000]),
        ("plans changed", [float(run.replans) for run in runs]),
    ]
    lines = [
        f"{len(runs)} random missions; {sum(run.lost for run in runs)} of "
        f"{sum(run.drones for run in runs)} drones lost; {sum(run.visited for run in runs):,} of {places:,} "
        f"waypoints visited; {len(unserved)} missions did not visit all, "
        f"{sum(run.somebody_left for run in unserved)} of them though a drone was left; "
        f"{len(study.broken)} broke a rule.",
        "",
        "| | mean | median | 95 % | least | most |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for what, values in rows:
        if values:
            middle = (statistics.fmean(values), statistics.median(values), percentile(values, 95))
            cells = (*middle, min(values), max(values))
            lines.append(f"| {what} | " + " | ".join(f"{cell:.2f}" for cell in cells) + " |")
    lines += [f"- seed {each}" for each in study.broken]
    return "\n".join(lines) + "\n"


def write(folder: Path, name: str, about: dict[str, Any], study: Study) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about, "broken": study.broken, "runs": [asdict(run) for run in study.runs]}
    (folder / f"{name}.json").write_text(json.dumps(whole, separators=(",", ":")) + "\n")
    (folder / f"{name}.md").write_text(table(study))
    (folder / f"{name}.svg").write_text(picture(study))


def picture(study: Study) -> str:
    """Three distributions side by side: the share of all that is not above."""
    runs = study.runs
    panels = [
        (
            "run's time / without failures, by drones lost",
            {
                label: [run.ratio for run in runs if min(run.lost, 2) == lost]
                for lost, label in enumerate(("none lost", "1 lost", "2 or more lost"))
            },
        ),
        ("orphan's wait, s", {"all": [wait for run in runs for wait in run.waits]}),
        ("waypoints visited, %", {"all": [100 * run.visited / run.waypoints for run in runs]}),
    ]
    size = f'width="{len(panels) * WIDTH}" height="{HEIGHT}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="11">',
        f'<rect {size} fill="white"/>',
    ]
    for number, (title, series) in enumerate(panels):
        shown = {label: sorted(values) for label, values in series.items() if values}
        if shown:
            parts.append(f'<g transform="translate({number * WIDTH},0)">{"".join(_panel(title, shown))}</g>')
    return "\n".join([*parts, "</svg>"]) + "\n"


def _panel(title: str, series: dict[str, list[float]]) -> list[str]:
    least = min(values[0] for values in series.values())
    most = max(values[-1] for values in series.values())
    span = most - least or 1.0
    parts = [f'<text x="{LEFT}" y="22">{title}</text>']
    for tick in range(TICKS + 1):
        share = tick / TICKS
        x, y = LEFT + PLOT_WIDTH * share, TOP + PLOT_HEIGHT * (1 - share)
        parts.append(
            f'<line x1="{LEFT}" y1="{y:.1f}" x2="{LEFT + PLOT_WIDTH}" y2="{y:.1f}" stroke="#ddd"/>'
            f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{100 * share:.0f} %</text>'
            f'<text x="{x:.1f}" y="{TOP + PLOT_HEIGHT + 16}" text-anchor="middle">'
            f"{least + span * share:.4g}</text>"
        )
    for number, (label, values) in enumerate(series.items()):
        colour, points = COLOURS[number], _steps(values, least, span)
        parts.append(
            f'<polyline fill="none" stroke="{colour}" stroke-width="2" points="{points}"/>'
            f'<text x="{LEFT + PLOT_WIDTH - 4}" y="{TOP + PLOT_HEIGHT - 10 - 15 * number}" text-anchor="end" '
            f'fill="{colour}">{label}: {len(values):,}</text>'
        )
    return parts


def _steps(values: list[float], least: float, span: float) -> str:
    """At most two hundred points of the curve, its ends among them."""
    stride = max(1, math.ceil(len(values) / 200))
    chosen = [*range(0, len(values), stride), len(values) - 1]
    return " ".join(
        f"{LEFT + PLOT_WIDTH * (values[at] - least) / span:.1f},"
        f"{TOP + PLOT_HEIGHT * (1 - (at + 1) / len(values)):.1f}"
        for at in chosen
    )
