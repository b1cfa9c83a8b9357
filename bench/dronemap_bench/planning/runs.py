"""One run of a solver in a process of its own."""

import resource
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from .. import machine
from ..programs import ROOT
from . import checker
from .problems import Row, moved

TARGET = ROOT / "bench" / "planning" / "target"
CLASSES = f"{TARGET}/*:{TARGET}/lib/*"
JAVA = ["java", "-Xmx2g", "-XX:+UseSerialGC", "-cp", CLASSES, "org.dronemap.bench.planning.SolverMain"]
"""The same for all: the collector has no threads of its own, the compiler has, and its CPU counts."""

SLOWEST = 4
"""A run that takes so much longer than its CPU would is given up: the machine is too busy to measure."""

AGREE = 1e-6


class RunError(Exception):
    """A solver that failed, or whose answer is wrong."""


@dataclass(frozen=True)
class SolverRun:
    """One run of a solver; CPU seconds are for all threads together."""

    solver: str
    seed: int
    seconds: float
    threads: int
    warm_up: float
    moved: bool


@dataclass(frozen=True)
class Result:
    """A checked result; `value` was recomputed from the tours, on the instance as it was read."""

    instance: str
    aim: str
    plan: SolverRun
    about: str
    value: float
    gap_percent: float
    cpu_seconds: float
    process_cpu_seconds: float
    others_percent: float
    points: list[tuple[float, float]]
    """CPU seconds and gap of each better plan."""
    tours: list[list[int]]


@dataclass(frozen=True)
class SolverOutput:
    """Parsed output of a solver's process."""

    about: str
    points: list[tuple[float, float]]
    used: float
    tours: list[list[int]]


def parse(lines: list[str]) -> SolverOutput:
    about, used = "", 0.0
    points: list[tuple[float, float]] = []
    tours: list[list[int]] = []
    for line in lines:
        word, _, rest = line.partition(" ")
        if word == "about":
            about = rest
        elif word == "improved":
            cpu, value = rest.split()
            points.append((float(cpu), float(value)))
        elif word == "used":
            used = float(rest)
        elif word == "tour":
            tours.append([int(waypoint) for waypoint in rest.split()])
    return SolverOutput(about, points, used, tours)


def run(row: Row, plan: SolverRun) -> Result:
    shifted = moved(row.problem, plan.seed) if plan.moved else None
    given = shifted.problem if shifted else row.problem
    before = (time.monotonic(), _children_cpu(), machine.busy_seconds())
    with tempfile.TemporaryDirectory(prefix="dronemap-plan-") as folder:
        file = Path(folder) / "problem"
        file.write_text(given.text())
        answer = parse(_java(file, plan).splitlines())
    wall, own = time.monotonic() - before[0], _children_cpu() - before[1]
    others = machine.busy_seconds() - before[2] - own
    _check(row, "as it was given", checker.faults(given, answer.tours))
    if not answer.points:
        raise RunError(f"{row.name}: {plan.solver} tells of no plan")
    claimed, reported = checker.value(given, answer.tours), answer.points[-1][1]
    if abs(claimed - reported) > AGREE * claimed:
        raise RunError(f"{row.name}: {plan.solver} says {reported}, its tours say {claimed}")
    tours = shifted.back(answer.tours) if shifted else answer.tours
    _check(row, "as it was read", checker.faults(row.problem, tours))
    value = checker.value(row.problem, tours)
    return Result(
        instance=row.name,
        aim=row.problem.aim,
        plan=plan,
        about=answer.about,
        value=value,
        gap_percent=gap(value, row.best),
        cpu_seconds=round(answer.used, 3),
        process_cpu_seconds=round(own, 3),
        others_percent=round(max(0.0, 100 * others / (wall * machine.CORES)), 1),
        points=[(round(cpu, 4), gap(found * value / claimed, row.best)) for cpu, found in answer.points],
        tours=tours,
    )


def gap(value: float, best: float) -> float:
    return round(100 * (value / best - 1), 4)


def _java(file: Path, plan: SolverRun) -> str:
    arguments = [
        plan.solver,
        str(file),
        str(plan.seed),
        str(plan.seconds),
        str(plan.threads),
        str(plan.warm_up),
    ]
    limit = SLOWEST * (plan.seconds + plan.warm_up) + 120
    command = [*JAVA, *arguments]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired as late:
        raise RunError(f"{plan.solver} had not ended after {limit:.0f} s") from late
    if done.returncode != 0:
        raise RunError(f"{plan.solver} failed:\n{done.stderr.strip()[-2000:]}")
    return done.stdout


def _children_cpu() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _check(row: Row, how: str, faults: list[str]) -> None:
    if faults:
        raise RunError(f"{row.name} {how}: {'; '.join(faults[:5])}")
