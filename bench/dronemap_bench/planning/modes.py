"""Modes of measurement, each with a name for the command line."""

from collections.abc import Callable
from dataclasses import dataclass

from .problems import Row

OURS = ("dronemap",)
LIBRARIES = ("dronemap", "ortools", "timefold", "jsprit")
BASELINES = ("given-order", "nearest-neighbour", "move-and-improve")

SEVEN = ("mtsp51_m3", "mtsp150_m5", "kroa200_m3", "rat99_m5", "pr299_m5", "md25", "md41")
"""Small and large, one depot and several."""

SMALL, LARGE = 600, 6000
WARM_UP = 4.0


@dataclass(frozen=True)
class Mode:
    name: str
    what: str
    selects: Callable[[Row], bool]
    seconds: tuple[float, ...]
    solvers: tuple[str, ...] = OURS
    seeds: int = 1
    threads: int = 1
    warm_up: float = WARM_UP
    moved: bool = False


def _small(aim: str) -> Callable[[Row], bool]:
    return lambda row: row.published and row.problem.aim == aim and row.size <= SMALL


def _seven(row: Row) -> bool:
    return row.problem.aim == "longest" and row.name in SEVEN


MODES = (
    Mode("minmax-1s", "published min-max rows up to 600 waypoints, warm", _small("longest"), (1,)),
    Mode("minmax-10s", "the same for 10 s", _small("longest"), (10,)),
    Mode("minsum-10s", "published min-sum rows up to 600 waypoints, warm", _small("sum"), (10,)),
    Mode(
        "large-10s",
        "published rows of 600 to 6,000 waypoints, warm",
        lambda row: row.published and SMALL < row.size <= LARGE,
        (10,),
    ),
    Mode(
        "depots-60s",
        "published rows with several depots, two threads with 60 s each, warm",
        lambda row: row.published and len(set(row.problem.depots)) > 1,
        (120,),
        threads=2,
    ),
    Mode(
        "libraries",
        "seven min-max instances beside public solvers, from the start of each process",
        _seven,
        (1, 5, 10),
        solvers=LIBRARIES,
        seeds=5,
        warm_up=0,
    ),
    Mode("moved", "the seven rotated, scaled and renumbered, warm", _seven, (1, 10), seeds=5, moved=True),
    Mode(
        "baselines",
        "plain ways to plan, on published min-max rows up to 600 waypoints",
        _small("longest"),
        (1,),
        solvers=BASELINES,
        warm_up=0,
    ),
)


def named(name: str) -> Mode:
    for mode in MODES:
        if mode.name == name:
            return mode
    raise SystemExit(f"There is no mode '{name}', only {', '.join(mode.name for mode in MODES)}.")
