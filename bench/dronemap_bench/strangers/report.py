"""Summarises a run with strangers: the rounds' medians and worst, and whether the goals are met."""

from statistics import median

from ..programs import Json
from .trial import CALM, CONTROL, OTHERS

MOST_TIMES = 2.0
MOST_MEGABYTES_MORE = 20.0
MEGABYTES_TO_SEND = 2_000
WORDS = {"viewers": "age on the stream", "vehicles": "heartbeats late by", "calls": "REST"}


def summary(result: Json) -> Json:
    """For each port: the others' p99 under attack by that of the calm right before, and what was sent."""
    windows: list[Json] = result["windows"]
    calm = {(window["before"], window["round"]): window for window in windows if window["what"] == CALM}
    ports: Json = {}
    for name in dict.fromkeys(window["what"] for window in windows if window["what"] != CALM):
        mine = [window for window in windows if window["what"] == name]
        ports[name] = {
            "gigabytes": round(sum(window["attack"]["bytes"] for window in mine) / 1e9, 2),
            "connections": sum(window["attack"]["connections"] for window in mine),
            "turnedAway": sum(window["attack"]["turnedAway"] for window in mine),
            "heapMegabytes": [window["liveHeapMegabytes"] for window in mine],
            "serverPercentOfOneCore": median(window["serverPercentOfOneCore"] for window in mine),
            "strangersPercentOfOneCore": median(window["strangersPercentOfOneCore"] for window in mine),
            "late": {who: _times(mine, calm, who) for who in OTHERS},
        }
    return {
        "calm": {who: _spread([window["late"][who]["p99"] for window in calm.values()]) for who in OTHERS},
        "calmHeapMegabytes": [window["liveHeapMegabytes"] for window in calm.values()],
        "elsePercentOfOneCore": median(window["elsePercentOfOneCore"] for window in calm.values()),
        "ports": ports,
    }


def _spread(values: list[float]) -> Json:
    return {"median": round(median(values), 2), "worst": round(max(values), 2)}


def _times(mine: list[Json], calm: dict[tuple[str, int], Json], who: str) -> Json:
    p99 = [window["late"][who]["p99"] for window in mine]
    before = [calm[window["what"], window["round"]]["late"][who]["p99"] for window in mine]
    times = [after / max(first, 0.1) for after, first in zip(p99, before, strict=True)]
    return {"p99": _spread(p99), "times": _spread(times)}


def missed(figures: Json, result: Json, vehicles: int) -> list[str]:
    """The goals that were not met, a sentence each."""
    live = result["liveVehiclesAtTheEnd"]
    found = [] if live == vehicles else [f"{live} of {vehicles} vehicles were live at the end"]
    flat = max(figures["calmHeapMegabytes"]) + MOST_MEGABYTES_MORE
    for name, port in figures["ports"].items():
        if name == CONTROL:
            continue
        # Who comes from one address waits so often that it sends little.
        if result["options"]["many_addresses"] and port["gigabytes"] < MEGABYTES_TO_SEND / 1_000:
            found.append(f"{name}: only {port['gigabytes']} GB could be sent")
        if max(port["heapMegabytes"]) > flat:
            found.append(f"{name}: the heap grew to {max(port['heapMegabytes'])} MB")
        found += [
            f"{name}: p99 of {WORDS[who]} was {late['times']['median']} times that of calm (median)"
            for who, late in port["late"].items()
            if late["times"]["median"] > MOST_TIMES
        ]
    return found


def table(figures: Json, about: dict[str, str]) -> str:
    head = ["attacked", "sent GB", "connections", "heap MB", "server %", "strangers %"]
    lines = [
        f"{about['processor']}, {about['java']}, revision {about['revision']}; something else took"
        f" {figures['elsePercentOfOneCore']} % of a core meanwhile. p99 in ms: median of the rounds (worst).",
        "",
        "| " + " | ".join([*head, *(WORDS[who] for who in OTHERS)]) + " |",
        "|" + " --- |" * (len(head) + len(OTHERS)),
        _row(
            "nothing",
            ["–", "–", _heap(figures["calmHeapMegabytes"]), "–", "–"],
            [f"{figures['calm'][who]['median']} ({figures['calm'][who]['worst']})" for who in OTHERS],
        ),
    ]
    for name, port in figures["ports"].items():
        cells = [port["gigabytes"], port["connections"], _heap(port["heapMegabytes"])]
        cells += [port["serverPercentOfOneCore"], port["strangersPercentOfOneCore"]]
        lines.append(_row(name, cells, [_late(port["late"][who]) for who in OTHERS]))
    return "\n".join(lines)


def _row(name: str, cells: list[object], late: list[str]) -> str:
    return "| " + " | ".join([name, *map(str, cells), *late]) + " |"


def _heap(megabytes: list[float]) -> str:
    return f"{min(megabytes)}–{max(megabytes)}"


def _late(of: Json) -> str:
    p99, times = of["p99"], of["times"]
    return f"{p99['median']} ({p99['worst']}): {times['median']} × ({times['worst']} ×)"
