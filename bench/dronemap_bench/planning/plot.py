"""Plots how each solver's best plan improved, as one picture for all instances."""

import math
import statistics

from ..report import COLOURS
from .runs import Result

COLUMNS, WIDTH, HEIGHT = 3, 340, 240
LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 52, 34, 270, 160
LEAST_GAP, MOST_GAP = 0.01, 100.0
LEAST_SECONDS = 0.01
LEGEND = 30


def convergence(results: list[Result]) -> str:
    """Both axes are logarithmic; a gap below a hundredth of a percent lies on the lower edge."""
    panels = sorted({(r.aim, r.instance) for r in results})
    solvers = sorted({r.plan.solver for r in results})
    lines = math.ceil(len(panels) / COLUMNS)
    most = max(r.plan.seconds for r in results)
    size = f'width="{COLUMNS * WIDTH}" height="{lines * HEIGHT + LEGEND}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="11">',
        f'<rect {size} fill="white"/>',
    ]
    for number, solver in enumerate(solvers):
        x, colour = LEFT + 170 * number, COLOURS[number % len(COLOURS)]
        parts.append(
            f'<line x1="{x}" y1="14" x2="{x + 24}" y2="14" stroke="{colour}" stroke-width="2"/>'
            f'<text x="{x + 30}" y="18">{solver}</text>'
        )
    for number, (aim, instance) in enumerate(panels):
        here = [r for r in results if (r.aim, r.instance) == (aim, instance)]
        x, y = number % COLUMNS * WIDTH, number // COLUMNS * HEIGHT + LEGEND
        title = f"{instance} ({aim}): gap in % over CPU seconds"
        parts.append(f'<g transform="translate({x},{y})">{"".join(_panel(title, here, solvers, most))}</g>')
    return "\n".join([*parts, "</svg>"]) + "\n"


def _panel(title: str, results: list[Result], solvers: list[str], most: float) -> list[str]:
    parts = [f'<text x="{LEFT}" y="22">{title}</text>']
    for decade in range(-2, 3):
        y = _y(10.0**decade)
        parts.append(
            f'<line x1="{LEFT}" y1="{y:.1f}" x2="{LEFT + PLOT_WIDTH}" y2="{y:.1f}" stroke="#ddd"/>'
            f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0**decade:g}</text>'
        )
    seconds = LEAST_SECONDS
    while seconds <= most * 1.001:
        x = _x(seconds, most)
        parts.append(
            f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{TOP + PLOT_HEIGHT}" stroke="#eee"/>'
            f'<text x="{x:.1f}" y="{TOP + PLOT_HEIGHT + 16}" text-anchor="middle">{seconds:g}</text>'
        )
        seconds *= 10
    for number, solver in enumerate(solvers):
        result = typical([r for r in results if r.plan.solver == solver])
        if result:
            parts.append(_curve(result, COLOURS[number % len(COLOURS)], most))
    return parts


def typical(results: list[Result]) -> Result | None:
    """The run, among the longest, that ends nearest the median."""
    if not results:
        return None
    longest = max(r.plan.seconds for r in results)
    runs = [r for r in results if r.plan.seconds == longest]
    middle = statistics.median(r.gap_percent for r in runs)
    return min(runs, key=lambda r: abs(r.gap_percent - middle))


def _curve(result: Result, colour: str, most: float) -> str:
    corners: list[str] = []
    last = None
    for cpu, gap in [*result.points, (result.cpu_seconds, result.gap_percent)]:
        x = _x(cpu, most)
        if last is not None:
            corners.append(f"{x:.1f},{last:.1f}")
        last = _y(gap)
        corners.append(f"{x:.1f},{last:.1f}")
    return f'<polyline points="{" ".join(corners)}" fill="none" stroke="{colour}" stroke-width="1.5"/>'


def _x(seconds: float, most: float) -> float:
    share = math.log(min(most, max(LEAST_SECONDS, seconds)) / LEAST_SECONDS) / math.log(most / LEAST_SECONDS)
    return LEFT + PLOT_WIDTH * share


def _y(gap: float) -> float:
    share = math.log(min(MOST_GAP, max(LEAST_GAP, gap)) / LEAST_GAP) / math.log(MOST_GAP / LEAST_GAP)
    return TOP + PLOT_HEIGHT * (1 - share)
