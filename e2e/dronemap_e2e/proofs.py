"""What real autopilots were seen to do: lines of a table for users, written by the trial that flies."""

import os
from pathlib import Path

from .server import ROOT

SETTING = "DRONEMAP_PROOFS"
COLUMNS = ("vehicle", "firmware", "job", "how")
# In the order of the table.
JOBS = (
    "Listed with its name, mode, place and battery",
    "Arm, disarm",
    "Change the mode",
    "Take off",
    "Go to a place",
    "Hold",
    "Turn on the spot",
    "Change speed",
    "Land",
    "Return home",
    "Mission sent, read back the same, cleared",
    "Mission: take off",
    "Mission: waypoint that holds",
    "Mission: wait, photo, servo",
    "Mission: look at a place, look ahead",
    "Mission: land",
    "Mission: return home",
    "Mission paused and continued",
    "Fence on board",
    "Rally points",
    "Parameters",
    "Flight logs",
    "Home moved",
    "Picture, relay",
    "Mission run with other vehicles",
)


class Proofs:
    """The lines of one vehicle. Without a file in DRONEMAP_PROOFS nothing is written."""

    def __init__(self, vehicle: str, firmware: str) -> None:
        self._vehicle = vehicle
        self._firmware = firmware
        named = os.environ.get(SETTING)
        self._file = ROOT / named if named else None

    def begin(self) -> None:
        """What was proved of this vehicle before counts for nothing."""
        self._write([line for line in self._read() if line[0] != self._vehicle])

    def add(self, job: str, how: str = "yes") -> None:
        assert job in JOBS, f"no such job: {job}"
        line = (self._vehicle, self._firmware, job, how)
        self._write([*(one for one in self._read() if (one[0], one[2]) != (self._vehicle, job)), line])

    def _read(self) -> list[tuple[str, ...]]:
        return read(self._file) if self._file and self._file.exists() else []

    def _write(self, lines: list[tuple[str, ...]]) -> None:
        if self._file:
            text = "\n".join("\t".join(line) for line in [COLUMNS, *sorted(lines, key=_place)])
            self._file.write_text(text + "\n", encoding="utf-8")


def read(file: Path) -> list[tuple[str, ...]]:
    """Vehicle, firmware, job and how, without the head."""
    return [tuple(line.split("\t")) for line in file.read_text(encoding="utf-8").splitlines()[1:]]


def _place(line: tuple[str, ...]) -> tuple[str, int]:
    return line[0], JOBS.index(line[2])
