"""Summarises rounds: medians and worst of each version, and the goals that were missed."""

from collections.abc import Callable
from statistics import median

from ..programs import Json

NOW, BEFORE = "now", "before"
FIGURES: dict[str, Callable[[Json], float]] = {
    "REST, one drone, p50 ms": lambda r: r["calls"]["oneByRest"]["p50"],
    "REST, one drone, p95 ms": lambda r: r["calls"]["oneByRest"]["p95"],
    "SOAP, one drone, p50 ms": lambda r: r["calls"]["oneBySoap"]["p50"],
    "SOAP more than REST, p50 ms": lambda r: r["calls"]["soapMoreAtP50"],
    "REST, list of all, p95 ms": lambda r: r["calls"]["listByRest"]["p95"],
    "SOAP, list of all, p95 ms": lambda r: r["calls"]["listBySoap"]["p95"],
    "command by REST, p95 ms": lambda r: r["calls"]["commandByRest"]["p95"],
    "command by SOAP, p95 ms": lambda r: r["calls"]["commandBySoap"]["p95"],
    "stream, age p50 ms": lambda r: r["stream"]["ageMillis"]["p50"],
    "stream, age p99 ms": lambda r: r["stream"]["ageMillis"]["p99"],
    "stream, messages by positions": lambda r: r["stream"]["shareOfPositions"],
    "stream, processor µs a message": lambda r: r["stream"]["cpuMicrosPerMessage"],
    "stream, resident MB": lambda r: r["stream"]["residentMegabytes"],
}
# Milliseconds that the median of the rounds has to stay below.
GOALS = {
    "REST, list of all, p95 ms": 50.0,
    "command by REST, p95 ms": 10.0,
    "SOAP more than REST, p50 ms": 2.0,
}


def summary(rounds: dict[str, list[Json]]) -> Json:
    return {
        name: {
            version: {
                "median": round(median(figure(one) for one in all_of), 3),
                "least": round(min(figure(one) for one in all_of), 3),
                "most": round(max(figure(one) for one in all_of), 3),
            }
            for version, all_of in rounds.items()
        }
        for name, figure in FIGURES.items()
    }


def missed(figures: Json) -> list[str]:
    return [
        f"{name}: {figures[name][NOW]['median']} instead of less than {goal}"
        for name, goal in GOALS.items()
        if figures[name][NOW]["median"] >= goal
    ]


def table(figures: Json, about: dict[str, str], load: float) -> str:
    versions = list(next(iter(figures.values())))
    lines = [
        f"{about['processor']}, {about['java']}, revision {about['revision']}, load before {load:.2f}."
        " Median of the rounds (least to most).",
        "",
        "| figure | " + " | ".join(versions) + " |",
        "|" + " --- |" * (len(versions) + 1),
    ]
    for name, by_version in figures.items():
        cells = [f"{v['median']} ({v['least']} to {v['most']})" for v in by_version.values()]
        lines.append("| " + " | ".join([name, *cells]) + " |")
    return "\n".join(lines)
