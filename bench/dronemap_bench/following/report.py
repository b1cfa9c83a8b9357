"""Reports how far drones were from where they had to be: limits, a table, plots."""

import json
from dataclasses import asdict, dataclass
from html import escape
from pathlib import Path

from ..report import COLOURS

SLOW, POOR = "300 ms", "500 ± 200 ms, 10 % lost"
EXACT, PLACE, COURSE = "NONE", "PLACE", "PLACE_AND_COURSE"
FORESEEN, LAST_FIX, FORWARDED = "FORESEEN", "LAST_FIX", "FORWARDED"
WAYS = {
    FORESEEN: "foretold",
    LAST_FIX: "last fix, not foretold",
    FORWARDED: "fixes forwarded as places to go to",
}
NOISES = {
    EXACT: "exact",
    PLACE: "3 m wandering, 0.5 m white",
    COURSE: "the same, and it says how it moves (0.3 m/s)",
}
SIMULATED = "simulated"
WIDTH, HEIGHT, LEFT, TOP, PLOT_WIDTH, PLOT_HEIGHT = 400, 250, 44, 34, 330, 170


@dataclass(frozen=True)
class Row:
    """One kind of walk, followed in one way; metres."""

    walk: str
    link: str
    noise: str
    way: str
    mean: float
    reported: float
    phone: float
    quantiles: list[float]
    settled: float
    step: float
    series: list[float]
    vehicle: str = SIMULATED

    @property
    def p95(self) -> float:
        return self.quantiles[95]


def parse(line: str) -> Row:
    return Row(**json.loads(line))


def find(rows: list[Row], walk: str, link: str, noise: str, way: str, vehicle: str = SIMULATED) -> Row | None:
    wanted = (walk, link, noise, way, vehicle)
    return next((r for r in rows if (r.walk, r.link, r.noise, r.way, r.vehicle) == wanted), None)


def real(rows: list[Row]) -> list[str]:
    """The autopilots that were not simulated by us."""
    return [vehicle for vehicle in dict.fromkeys(row.vehicle for row in rows) if vehicle != SIMULATED]


def limits(rows: list[Row]) -> list[tuple[str, float, float]]:
    """Each goal with its figure and the most that it may be."""
    asked: list[tuple[str, float, float]] = []

    def mean(walk: str, link: str, noise: str, way: str = FORESEEN) -> Row | None:
        return find(rows, walk, link, noise, way)

    for walk, most in (("walking", 1.0), ("running", 1.5), ("cycling", 4.0)):
        for vehicle in (SIMULATED, *real(rows)):
            if row := find(rows, walk, SLOW, EXACT, FORESEEN, vehicle):
                what = f"{walk}, exact phone{'' if vehicle == SIMULATED else f', {vehicle}'}"
                asked.append((f"{what}: mean", row.mean, most))
                if walk == "walking":
                    asked.append((f"{what}: 95 %", row.p95, 2.0))
        for noise in (PLACE, COURSE):
            if row := mean(walk, SLOW, noise):
                asked.append((f"{walk}, phone {NOISES[noise]}: mean", row.mean, row.phone + 1))
    if row := mean("walking", POOR, EXACT):
        asked.append((f"walking, {POOR}: mean", row.mean, 2.0))
    for walk in ("running", "cycling"):
        with_it, without = mean(walk, SLOW, EXACT), mean(walk, SLOW, EXACT, LAST_FIX)
        if with_it and without:
            asked.append((f"{walk}: foretold, share of not foretold", with_it.mean / without.mean, 0.7))
    return asked


def table(about: dict[str, str], seeds: int, rows: list[Row]) -> str:
    lines = [
        f"Flown {about['at']}, {about['java']}, revision {about['revision']}; {seeds} walks of each kind.",
        "Metres from the drone's true place to where it had to be beside the target's true place at the same",
        "moment, 20 times a second; *reported*: to where the newest report would have it.",
        "",
        "| limit | measured | at most | |",
        "| --- | --- | --- | --- |",
    ]
    for what, measured, most in limits(rows):
        verdict = "kept" if measured <= most else "**missed**"
        lines.append(f"| {what} | {measured:.2f} | {most:.2f} | {verdict} |")
    lines += ["", *_all(rows)]
    lines += [
        "",
        "For comparison: the paper's drone was 3 to 4 m from the reported place at a walk and up to 11.8 m",
        "at a run; 34 m when its phone went to sleep.",
    ]
    return "\n".join(lines) + "\n"


def _all(rows: list[Row]) -> list[str]:
    """A row for each way of following in the simulator, beside it what real autopilots made of the same."""
    vehicles = real(rows)
    heads = [
        "walk",
        "network, each way",
        "phone",
        "target",
        "mean",
        "95 %",
        "reported, mean",
        "phone's own error",
    ]
    heads += [f"{vehicle}: mean (95 %)" for vehicle in vehicles]
    lines = [f"| {' | '.join(heads)} |", "|" + " --- |" * len(heads)]
    for row in rows:
        if row.vehicle == SIMULATED:
            arguments = [row.walk, row.link, NOISES[row.noise], WAYS[row.way]]
            arguments += [f"{figure:.2f}" for figure in (row.mean, row.p95, row.reported, row.phone)]
            for vehicle in vehicles:
                beside = find(rows, row.walk, row.link, row.noise, row.way, vehicle)
                arguments.append(f"{beside.mean:.2f} ({beside.p95:.2f})" if beside else "–")
            lines.append(f"| {' | '.join(arguments)} |")
    return lines


def write(folder: Path, name: str, about: dict[str, str], seeds: int, rows: list[Row]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about, "seeds": seeds, "rows": [asdict(row) for row in rows]}
    (folder / f"{name}.json").write_text(json.dumps(whole, separators=(",", ":")) + "\n")
    (folder / f"{name}.md").write_text(table(about, seeds, rows))
    (folder / f"{name}.html").write_text(page(about, seeds, rows))


def page(about: dict[str, str], seeds: int, rows: list[Row]) -> str:
    parts = [
        "<!doctype html><html lang='en'><head><meta charset='utf-8'><title>Following a phone</title>",
        "<style>body{font:15px sans-serif;max-width:75em;margin:2em auto;padding:0 1em}",
        "table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #ccc;padding:.25em .6em;",
        "text-align:left}svg{max-width:100%}</style></head><body><h1>Following a phone</h1>",
    ]
    inside = False
    for line in table(about, seeds, rows).splitlines():
        cells = [escape(cell.strip().strip("*")) for cell in line.strip("|").split("|")]
        if not line.startswith("|"):
            parts.append(("</table>" if inside else "") + (f"<p>{escape(line)}</p>" if line else ""))
            inside = False
        elif not inside:
            parts.append("<table><tr>" + "".join(f"<th>{cell}</th>" for cell in cells) + "</tr>")
            inside = True
        elif not line.startswith("| ---"):
            parts.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    parts.append("</table>" if inside else "")
    for noise in (EXACT, PLACE):
        parts.append(f"<h2>{SLOW} each way, phone {escape(NOISES[noise])}</h2>{_legend(real(rows))}")
        for walk in dict.fromkeys(row.walk for row in rows):
            here = [row for row in rows if (row.walk, row.link, row.noise) == (walk, SLOW, noise)]
            if here:
                parts += [_over_time(walk, here), _shares(walk, here)]
    return "\n".join([*parts, "</body></html>"]) + "\n"


def _legend(vehicles: list[str]) -> str:
    arguments = [
        f"<span style='color:{COLOURS[number]}'>■</span> {escape(word)}"
        for number, word in enumerate([*WAYS.values(), *(f"foretold, {name}" for name in vehicles)])
    ]
    return f"<p>{' &nbsp; '.join(arguments)}</p>"


def _colour(row: Row) -> int:
    """Real autopilots have the next one."""
    return list(WAYS).index(row.way) if row.vehicle == SIMULATED else len(WAYS)


def _over_time(walk: str, rows: list[Row]) -> str:
    most = max(max(row.series, default=1.0) for row in rows) or 1.0
    seconds = max(len(row.series) * row.step for row in rows)
    settled = rows[0].settled
    curves = [
        (
            _colour(row),
            [(number * row.step / seconds, value / most) for number, value in enumerate(row.series)],
        )
        for row in rows
    ]
    return _plot(
        f"{walk}: metres over seconds (first walk)",
        (f"{settled:.0f}", f"{settled + seconds:.0f} s"),
        f"{most:.0f}",
        curves,
    )


def _shares(walk: str, rows: list[Row]) -> str:
    most = max(row.quantiles[99] for row in rows) or 1.0
    curves = [
        (
            _colour(row),
            [(min(1.0, value / most), percent / 100) for percent, value in enumerate(row.quantiles)],
        )
        for row in rows
    ]
    return _plot(f"{walk}: share of the time within so many metres", ("0", f"{most:.0f} m"), "1", curves)


def _plot(
    title: str, across: tuple[str, str], up: str, curves: list[tuple[int, list[tuple[float, float]]]]
) -> str:
    right, floor = LEFT + PLOT_WIDTH, TOP + PLOT_HEIGHT
    parts = [
        f"<svg xmlns='http://www.w3.org/2000/svg' width='{WIDTH}' height='{HEIGHT}' font-size='12'>",
        f"<text x='{LEFT}' y='20'>{escape(title)}</text>",
        f"<path d='M{LEFT},{TOP}V{floor}H{right}' stroke='#888' fill='none'/>",
        f"<text x='{LEFT - 4}' y='{TOP + 8}' text-anchor='end'>{escape(up)}</text>",
        f"<text x='{LEFT - 4}' y='{floor}' text-anchor='end'>0</text>",
        f"<text x='{LEFT}' y='{floor + 16}'>{escape(across[0])}</text>",
        f"<text x='{right}' y='{floor + 16}' text-anchor='end'>{escape(across[1])}</text>",
    ]
    for number, points in curves:
        colour = COLOURS[number]
        line = " ".join(f"{LEFT + x * PLOT_WIDTH:.1f},{floor - y * PLOT_HEIGHT:.1f}" for x, y in points)
        parts.append(f"<polyline points='{line}' stroke='{colour}' fill='none' stroke-width='1.5'/>")
    return "".join([*parts, "</svg>"])
