"""Sums up the flights of the trial of separation, a line for each scenario.

Usage: separation_table.py [FILE]

FILE (docs/trials/separation-flights.tsv) has a line for each flight, as e2e/dronemap_e2e/separation_judge.py
writes them.
"""

import csv
import math
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FLIGHTS = ROOT / "docs" / "trials" / "separation-flights.tsv"
COLUMNS = (
    *("scenario", "seeds", "breaches off", "breaches on", "least distance off", "least distance on"),
    *("left out or late on", "longest time on"),
)
Row = dict[str, str]


def breaches(flights: Sequence[Row]) -> str:
    """Flights with a breach, out of how many, and their share."""
    if not flights:
        return "-"
    found = sum(int(flight["breaches"]) > 0 for flight in flights)
    return f"{found} of {len(flights)} ({100 * found / len(flights):.0f} %)"


def least_distance(flights: Iterable[Row]) -> str:
    """Metres beside and above each other where two were nearest, as a share of what keeps them apart."""
    nearest = min(
        (flight for flight in flights if flight["share"]),
        key=lambda flight: float(flight["share"]),
        default=None,
    )
    return "-" if nearest is None else f"{nearest['horizontal']} m / {nearest['vertical']} m"


def failings(flights: Sequence[Row]) -> str:
    """Flights in which waypoints were left out, or somebody was down too late or not at all."""
    if not flights:
        return "-"
    return str(sum(int(flight["unserved"]) + int(flight["late"]) > 0 for flight in flights))


def longest_time(flights: Iterable[Row]) -> str:
    """As a multiple of what the operation needs alone."""
    longest = max((float(flight["factor"]) for flight in flights), default=0.0)
    if math.isinf(longest):
        return "not down"
    return f"{longest:.2f}" if longest else "-"


def summary(rows: Sequence[Row]) -> list[list[str]]:
    lines = []
    for scenario in sorted({row["scenario"] for row in rows}):
        own = [row for row in rows if row["scenario"] == scenario]
        off = [row for row in own if row["mechanism"] == "off"]
        on = [row for row in own if row["mechanism"] == "on"]
        lines.append(
            [
                *(scenario, str(len({row["seed"] for row in own})), breaches(off), breaches(on)),
                *(least_distance(off), least_distance(on), failings(on), longest_time(on)),
            ]
        )
    return lines


def printed(lines: Sequence[Sequence[str]]) -> str:
    table = [COLUMNS, *lines]
    widths = [max(len(line[column]) for line in table) for column in range(len(COLUMNS))]
    return "\n".join(
        "  ".join(word.ljust(width) for word, width in zip(line, widths, strict=True)).rstrip()
        for line in table
    )


def main(arguments: Sequence[str]) -> int:
    file = Path(arguments[0]) if arguments else FLIGHTS
    try:
        with file.open(encoding="utf-8", newline="") as lines:
            rows = list(csv.DictReader(lines, delimiter="\t"))
        print(printed(summary(rows)))
    except (OSError, KeyError, ValueError) as error:
        print(f"dronemap: {file} is not readable: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
