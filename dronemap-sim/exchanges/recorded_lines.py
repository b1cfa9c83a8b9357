"""Reads recordings of exchanges, and selects lines of them and the times between lines."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

Line = Mapping[str, Any]
Lines = list[Line]


def load(folder: Path, name: str) -> Lines:
    """The lines of one recording."""
    text = (folder / f"{name}.jsonl").read_text(encoding="utf-8")
    return [json.loads(line) for line in text.splitlines()]


def seconds(line: Line) -> float:
    """Seconds of the line from the start of the exchange."""
    return float(line["t_ms"]) / 1000


def matches(line: Line, wanted: Mapping[str, Any]) -> bool:
    """True when each wanted field is so; a text need only begin so."""
    return all(
        str(line.get(field, "")).startswith(value) if field == "text" else line.get(field) == value
        for field, value in wanted.items()
    )


def seconds_of(lines: Iterable[Line], after: float = -math.inf, **wanted: Any) -> float:
    """Seconds of the first matching line after `after`."""
    for line in lines:
        if seconds(line) > after and matches(line, wanted):
            return seconds(line)
    raise LookupError(f"no line with {wanted}")


def last_seconds_of(lines: Iterable[Line], before: float, **wanted: Any) -> float:
    """Seconds of the last matching line before `before`."""
    return max(seconds(line) for line in lines if seconds(line) < before and matches(line, wanted))


def between(lines: Lines, first: Mapping[str, Any], then: Mapping[str, Any]) -> float:
    """Seconds from one line to the first later one of another kind."""
    started = seconds_of(lines, **first)
    return seconds_of(lines, after=started, **then) - started


def values(lines: Lines, msg: str, field: str, start: float = -math.inf, end: float = math.inf) -> list[float]:
    """One field of all messages of a kind, within a time."""
    return [float(line[field]) for line in lines if line["msg"] == msg and start <= seconds(line) <= end]


def sent(command: int) -> dict[str, Any]:
    """The COMMAND_LONG of this command."""
    return {"dir": "to", "msg": "COMMAND_LONG", "command": command}


def landed(state: int) -> dict[str, Any]:
    """EXTENDED_SYS_STATE: 1 on the ground, 2 in the air, 3 taking off, 4 landing."""
    return {"msg": "EXTENDED_SYS_STATE", "landed_state": state}


def status_text(text: str) -> dict[str, Any]:
    """A STATUSTEXT that begins so."""
    return {"msg": "STATUSTEXT", "text": text}


def in_mode(mode: str) -> dict[str, Any]:
    """A HEARTBEAT of that mode."""
    return {"msg": "HEARTBEAT", "mode": mode}
