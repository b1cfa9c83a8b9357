"""Reads scripts/trials.toml: the trials that are declared, and the units of each."""

import os
import re
import shlex
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FAILED = 1
RANGE = re.compile(r"(\d{1,6})-(\d{1,6})")
NAME = re.compile(r"[a-z][a-z0-9-]*")
KEYS: dict[str, type | tuple[type, ...]] = {
    "says": str,
    "run": str,
    "units": (str, list),
    "files": str,
    "except": list,
    "busy": int,
    "needs": (str, dict),
}


class TrialRefused(Exception):
    """A refusal: its sentence and the exit code."""

    def __init__(self, sentence: str, code: int = FAILED) -> None:
        super().__init__(sentence)
        self.code = code


@dataclass(frozen=True)
class Trial:
    """One entry of the table."""

    name: str
    description: str
    run: str
    units: list[str]
    busy: int = 0
    # An environment variable by unit; those that are not here need none.
    needs: dict[str, str] = field(default_factory=dict)

    def missing_setting(self, unit: str) -> str | None:
        """The environment variable without which the unit would prove nothing."""
        setting = self.needs.get(unit)
        return setting if setting is not None and not os.environ.get(setting) else None

    def command(self, unit: str) -> list[str]:
        return [word.replace("{unit}", unit) for word in shlex.split(self.run)]


def parse_units(name: str, entry: dict[str, Any], root: Path) -> list[str]:
    if "files" in entry:
        left_out = set(entry.get("except", []))
        files = sorted(str(path.relative_to(root)) for path in root.glob(entry["files"]))
        return [file for file in files if file not in left_out]
    units = entry.get("units")
    if isinstance(units, list):
        return [str(unit) for unit in units]
    bounds = RANGE.fullmatch(units or "")
    if bounds is None or int(bounds[1]) > int(bounds[2]):
        raise TrialRefused(
            f"The trial '{name}' has the units '{units}'; they must be a range such as 1-20, or a list."
        )
    return [str(number) for number in range(int(bounds[1]), int(bounds[2]) + 1)]


def parse_trial(name: str, entry: dict[str, Any], root: Path) -> Trial:
    if NAME.fullmatch(name) is None:
        raise TrialRefused(f"The trial '{name}' must have a name of small letters, digits and hyphens.")
    for key, value in entry.items():
        if key not in KEYS or not isinstance(value, KEYS[key]):
            raise TrialRefused(f"The trial '{name}' has '{key} = {value}', which no trial may have.")
    if "says" not in entry or "run" not in entry:
        raise TrialRefused(f"The trial '{name}' needs what it says and what it runs.")
    units = parse_units(name, entry, root)
    if not units or len(set(units)) != len(units) or any(re.search(r"\s", unit) for unit in units):
        raise TrialRefused(f"The trial '{name}' needs units, each of them once and without spaces.")
    return Trial(
        name, entry["says"], entry["run"], units, entry.get("busy", 0), parse_needs(name, entry, units)
    )


def parse_needs(name: str, entry: dict[str, Any], units: list[str]) -> dict[str, str]:
    needs = entry.get("needs", {})
    if isinstance(needs, str):
        return dict.fromkeys(units, needs)
    for unit, setting in needs.items():
        if unit not in units or not isinstance(setting, str):
            raise TrialRefused(f"The trial '{name}' has needs of '{unit}', which is none of its units.")
    return dict(needs)


def load_trials(root: Path) -> dict[str, Trial]:
    file = root / "scripts" / "trials.toml"
    try:
        table = tomllib.loads(file.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise TrialRefused(f"{file} is not readable: {error}") from error
    return {name: parse_trial(name, entry, root) for name, entry in table.items()}
