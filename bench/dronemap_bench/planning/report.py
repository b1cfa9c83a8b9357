"""Results as a table, a plot of how they came about, and JSON."""

import dataclasses
import json
import statistics
from pathlib import Path
from typing import Any

from . import plot
from .runs import Result

Json = dict[str, Any]
Key = tuple[str, float]
"""Solver and CPU seconds."""

TIE_PERCENT = 0.1
BEATEN_PERCENT = -0.01
"""Best values are written with two decimals: less than this is the same."""


def write(folder: Path, name: str, about: Json, results: list[Result]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about, "results": [dataclasses.asdict(result) for result in results]}
    (folder / f"{name}.json").write_text(json.dumps(whole, separators=(",", ":")) + "\n")
    (folder / f"{name}.md").write_text(table(about, results))
    (folder / f"{name}.svg").write_text(plot.convergence(results))


def table(about: Json, results: list[Result]) -> str:
    keys = sorted({_key(result) for result in results}, key=lambda key: (key[1], key[0]))
    rows = sorted({(result.aim, result.instance) for result in results})
    head = ["instance", "aim", *(f"{solver} {seconds:g} s" for solver, seconds in keys)]
    plan = results[0].plan
    start = (
        f"after {plan.warm_up:g} s of warm-up on random problems"
        if plan.warm_up
        else "from the process's start"
    )
    others = statistics.median(result.others_percent for result in results)
    seeds = len({result.plan.seed for result in results})
    lines = [
        f"Measured {about['at']} on {about['processor']}, {about['java']}, revision {about['revision']}; "
        f"others used {others:g} % of the machine (median).",
        f"Gap to the best known value in %, median of {seeds} seed{'s' if seeds > 1 else ''}; "
        f"process CPU {start}, {plan.threads} thread{'s' if plan.threads > 1 else ''}"
        f"{', instances rotated, scaled and renumbered' if plan.moved else ''}.",
        "",
        *(f"- `{solver}`: {what}" for solver, what in sorted({(r.plan.solver, r.about) for r in results})),
        "",
        _line(head),
        _line(["---"] * len(head)),
    ]
    for aim, instance in rows:
        cells = [_cell(median(results, aim, instance, key)) for key in keys]
        lines.append(_line([instance, aim, *cells]))
    for aim in sorted({aim for aim, _ in rows}):
        gaps = [[median(results, aim, name, key) for a, name in rows if a == aim] for key in keys]
        known = [[gap for gap in column if gap is not None] for column in gaps]
        lines.append(_line(["**mean**", aim, *(_cell(statistics.fmean(c) if c else None) for c in known)]))
        lines.append(_line(["**max**", aim, *(_cell(max(c, default=None)) for c in known)]))
    return "\n".join([*lines, *_spent(results, keys), *_against(results), *_beaten(results)]) + "\n"


def _key(result: Result) -> Key:
    return result.plan.solver, result.plan.seconds


def median(results: list[Result], aim: str, instance: str, key: Key) -> float | None:
    found = [r.gap_percent for r in results if (r.aim, r.instance, _key(r)) == (aim, instance, key)]
    return statistics.median(found) if found else None


def _cell(gap: float | None) -> str:
    return "–" if gap is None else f"{gap:.2f}"


def _line(cells: list[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def _spent(results: list[Result], keys: list[Key]) -> list[str]:
    """A library looks at its limit in its own rhythm."""
    most = {key: max(r.cpu_seconds for r in results if _key(r) == key) for key in keys}
    spent = ", ".join(f"{solver} {seconds:g} s: {most[solver, seconds]:.2f} s" for solver, seconds in keys)
    return ["", f"CPU really used, at most: {spent}."]


def _against(results: list[Result]) -> list[str]:
    """A table of how often ours is at least as good as each other solver."""
    lines = []
    others = sorted(
        {_key(r) for r in results if r.plan.solver != "dronemap"}, key=lambda key: (key[0], key[1])
    )
    for solver, seconds in others:
        pairs = [
            (median(results, aim, name, ("dronemap", seconds)), median(results, aim, name, (solver, seconds)))
            for aim, name in sorted({(r.aim, r.instance) for r in results})
        ]
        both = [(ours, theirs) for ours, theirs in pairs if ours is not None and theirs is not None]
        if both:
            good = sum(ours <= theirs + TIE_PERCENT for ours, theirs in both)
            lines.append(f"- against `{solver}` at {seconds:g} s: better or tied on {good} of {len(both)}")
    return ["", *lines] if lines else []


def _beaten(results: list[Result]) -> list[str]:
    better = sorted({r.instance for r in results if r.gap_percent < BEATEN_PERCENT})
    return ["", f"Better than the best known value: {', '.join(better)}."] if better else []
