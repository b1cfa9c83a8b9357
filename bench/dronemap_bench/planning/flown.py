"""Random plans flown by simulated copters in virtual time: what was foretold, and what it took."""

import json
import statistics
import subprocess
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from .losses import percentile
from .runs import CLASSES, RunError

JAVA = ["java", "-Xmx1g", "-cp", CLASSES, "org.dronemap.bench.planning.flown.FlownPlans"]
FIGURES = {"measured": "measured of that copter", "assumed": "as its autopilot is delivered"}


@dataclass(frozen=True)
class Flight:
    """One tour of one plan."""

    seed: int
    figures: str
    wind: float
    fences: int
    stops: int
    planned_seconds: float
    flown_seconds: float
    planned_joules: float
    flown_joules: float

    @property
    def late_percent(self) -> float:
        return 100 * (self.flown_seconds / self.planned_seconds - 1)

    @property
    def excess_energy_percent(self) -> float:
        return 100 * (self.flown_joules / self.planned_joules - 1)


def parse(lines: list[str]) -> list[Flight]:
    flights = [_flight(columns) for columns in map(str.split, lines) if columns and columns[0] == "flown"]
    return sorted(flights, key=lambda flight: (flight.figures, flight.seed))


def _flight(columns: list[str]) -> Flight:
    seed, figures, wind, fences, stops, *numbers = columns[1:]
    planned, flown, planned_joules, flown_joules = map(float, numbers)
    return Flight(
        int(seed), figures, float(wind), int(fences), int(stops), planned, flown, planned_joules, flown_joules
    )


def run(cases: int) -> list[Flight]:
    done = subprocess.run([*JAVA, "1", str(cases)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RunError(f"the flights ended early:\n{done.stderr.strip()[-2000:]}")
    return parse(done.stdout.splitlines())


def table(flights: list[Flight]) -> str:
    """A table of differences between flown and planned, without sign but for the mean."""
    plans = len({flight.seed for flight in flights})
    wind = max(flight.wind for flight in flights)
    fences = max(flight.fences for flight in flights)
    lines = [
        f"{plans} plans; wind up to {wind:.1f} m/s, up to {fences} fences.",
        "",
        "| flown beyond planned, % | tours | mean | 95 % off by | most off by |",
        "| --- | --- | --- | --- | --- |",
    ]
    deviations: list[tuple[str, Callable[[Flight], float]]] = [
        ("time", lambda flight: flight.late_percent),
        ("energy", lambda flight: flight.excess_energy_percent),
    ]
    for figures, description in FIGURES.items():
        own = [flight for flight in flights if flight.figures == figures]
        for what, off in deviations if own else []:
            values = [off(flight) for flight in own]
            sizes = [abs(value) for value in values]
            lines.append(
                f"| {what}, figures {description} | {len(own)} | {statistics.fmean(values):+.2f} "
                f"| {percentile(sizes, 95):.2f} | {max(sizes):.2f} |"
            )
    return "\n".join(lines) + "\n"


def meets_forecast(flights: list[Flight]) -> bool:
    """With measured figures each time within 5 % and each energy within 10 %."""
    own = [flight for flight in flights if flight.figures == "measured"]
    return all(abs(flight.late_percent) <= 5 and abs(flight.excess_energy_percent) <= 10 for flight in own)


def write(folder: Path, name: str, about: dict[str, Any], flights: list[Flight]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about, "flights": [asdict(flight) for flight in flights]}
    (folder / f"{name}.json").write_text(json.dumps(whole, separators=(",", ":")) + "\n")
    (folder / f"{name}.md").write_text(table(flights))
