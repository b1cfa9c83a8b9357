"""Writes results as a table, a plot and JSON."""

import json
import math
from pathlib import Path
from typing import Any

Json = dict[str, Any]

WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 960, 520, 70, 40, 620, 420
COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#e377c2", "#7f7f7f"]
SHOWN = ["50.0", "75.0", "90.0", "95.0", "99.0", "99.9", "99.99"]
LEAST_MILLIS, MOST_MILLIS = 0.1, 10_000


def write(folder: Path, name: str, results: Json) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.json").write_text(json.dumps(results, indent=2) + "\n")
    (folder / f"{name}.md").write_text(table(results))
    (folder / f"{name}.svg").write_text(plot(results))


def millis(result: Json, percentile: str) -> float:
    micros: int = result["stream"]["age"]["percentiles"][percentile]
    return micros / 1000


def table(results: Json) -> str:
    head = [
        "configuration",
        "sent /s",
        "kernel drops",
        "in tlogs",
        "of",
        "stream /s",
        "p50 ms",
        "p99 ms",
        "p99.9 ms",
        "CPU % of a core",
        "CPU us/message",
        "of it compiler",
        "kB/drone",
        "others %",
        "sender late p99 ms",
    ]
    rows = [row(result) for result in results["configurations"]]
    about = results["machine"]
    lines = [
        f"Measured {about['at']} on {about['processor']}, {about['java']}, revision {about['revision']}.",
        "",
        *(f"- `{r['name']}`: {r['what']}, {r['seconds']} s" for r in results["configurations"]),
        "",
        _line(head),
        _line(["---"] * len(head)),
        *(_line(cells) for cells in rows),
        *_beside(results),
    ]
    return "\n".join(lines) + "\n"


def _beside(results: Json) -> list[str]:
    """Lines about the same load through a router, under a flood, and with clients."""
    all_results = results["configurations"]
    lines = [_router(r) for r in all_results if r.get("router")]
    lines += [_flood(r) for r in all_results if r.get("flood")]
    lines += [_clients(r) for r in all_results if r.get("clients")]
    return ["", *lines] if lines else []


def _router(r: Json) -> str:
    beside = r["router"]
    return (
        f"- `{r['name']}` through mavlink-router: {beside['received']:,} of {beside['sent']:,} forwarded, "
        f"{beside['cpuMicrosPerMessage']} us/message"
    )


def _flood(r: Json) -> str:
    calm, flooded = (
        [each["percentiles"]["99.0"] / 1000 for each in r[when]["ageByHost"]] for when in ("calm", "stream")
    )
    return (
        f"- `{r['name']}`: {r['flood']['sent']:,} datagrams; p99 at the flooder's address "
        f"{calm[0]:.2f} ms before, {flooded[0]:.2f} ms under it, else {calm[1]:.2f} and {flooded[1]:.2f}; "
        f"memory {r['middleMegabytes']} and {r['busyMegabytes']} MB"
    )


def delivered(r: Json) -> float:
    """The share of all frames that reached ground stations at the outlet; heartbeats count like any other."""
    every: float = r["clients"]["clients"] * r["vehicles"] * r["rate"] * r["measuredSeconds"]
    return int(r["clients"]["frames"]) / every


def _clients(r: Json) -> str:
    calm, watched = (r[when]["age"]["percentiles"] for when in ("calm", "stream"))
    ages = [f"{calm[p] / 1000:.2f} and {watched[p] / 1000:.2f} ms" for p in ("50.0", "99.0")]
    clients = r["clients"]
    return (
        f"- `{r['name']}`: {clients['clients']} ground stations got {100 * delivered(r):.2f} % of all frames "
        f"({clients['frames'] / r['measuredSeconds']:,.0f}/s), {clients['stuck']} stuck beside them; "
        f"on the stream without and with them p50 {ages[0]}, p99 {ages[1]}"
    )


def row(r: Json) -> list[str]:
    late = r["sent"]["lateness"]["percentiles"]["99.0"] / 1000
    return [
        r["name"],
        f"{r['vehicles'] * r['rate']:,}",
        str(r["kernelDrops"]),
        f"{r['tlogs']['found']:,}",
        f"{r['tlogs']['expected']:,}",
        f"{r['stream']['messages'] / r.get('measuredSeconds', r['seconds']):.0f}",
        f"{millis(r, '50.0'):.2f}",
        f"{millis(r, '99.0'):.2f}",
        f"{millis(r, '99.9'):.2f}",
        f"{r['cpuPercentOfOneCore']}",
        f"{r['cpuMicrosPerMessage']}",
        f"{r['compilerMicrosPerMessage']}",
        f"{r['kilobytesPerDrone']}",
        f"{r['foreignLoadPercentOfMachine']}",
        f"{late:.2f}",
    ]


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def plot(results: Json) -> str:
    """Plots the age of positions on arrival: percentiles, each step to the right ten times rarer."""
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
        'font-family="sans-serif" font-size="12">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
        f'<text x="{LEFT}" y="24" font-size="16">From UDP in to WebSocket out, ms (open loop)</text>',
    ]
    decade = LEAST_MILLIS
    while decade <= MOST_MILLIS:
        y = _y(decade)
        parts.append(
            f'<line x1="{LEFT}" y1="{y:.1f}" x2="{LEFT + PLOT_WIDTH}" y2="{y:.1f}" stroke="#ddd"/>'
            f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{decade:g}</text>'
        )
        decade *= 10
    for percentile in SHOWN:
        x = _x(percentile)
        parts.append(
            f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{TOP + PLOT_HEIGHT}" stroke="#eee"/>'
            f'<text x="{x:.1f}" y="{TOP + PLOT_HEIGHT + 18}" text-anchor="middle">{percentile} %</text>'
        )
    for number, result in enumerate(results["configurations"]):
        parts += _curve(number, result)
    return "\n".join([*parts, "</svg>"]) + "\n"


def _curve(number: int, result: Json) -> list[str]:
    colour = COLOURS[number % len(COLOURS)]
    dash = "" if number < len(COLOURS) else ' stroke-dasharray="6 3"'
    points = " ".join(f"{_x(p):.1f},{_y(millis(result, p)):.1f}" for p in SHOWN)
    y = TOP + 16 + 20 * number
    x = LEFT + PLOT_WIDTH + 20
    return [
        f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"{dash}/>',
        f'<line x1="{x}" y1="{y - 4}" x2="{x + 24}" y2="{y - 4}" stroke="{colour}" stroke-width="2"{dash}/>',
        f'<text x="{x + 30}" y="{y}">{result["name"]}</text>',
    ]


def _x(percentile: str) -> float:
    nines = -math.log10(1 - float(percentile) / 100)
    first, last = -math.log10(0.5), 4.0
    return LEFT + PLOT_WIDTH * (nines - first) / (last - first)


def _y(value: float) -> float:
    decades = math.log10(min(MOST_MILLIS, max(LEAST_MILLIS, value)) / LEAST_MILLIS)
    return TOP + PLOT_HEIGHT * (1 - decades / math.log10(MOST_MILLIS / LEAST_MILLIS))
