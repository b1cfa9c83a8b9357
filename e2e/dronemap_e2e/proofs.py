"""What real autopilots were seen to do: lines of a table for users, written by the trial that flies."""

import os

from . import vehicle_table
from .server import ROOT

SETTING = "DRONEMAP_PROOFS"


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
        assert job in vehicle_table.JOBS, f"no such job: {job}"
        line = (self._vehicle, self._firmware, job, how)
        self._write([*(one for one in self._read() if (one[0], one[2]) != (self._vehicle, job)), line])

    def _read(self) -> list[tuple[str, ...]]:
        return vehicle_table.read(self._file) if self._file and self._file.exists() else []

    def _write(self, lines: list[tuple[str, ...]]) -> None:
        if self._file:
            text = "\n".join("\t".join(line) for line in [vehicle_table.COLUMNS, *sorted(lines, key=_place)])
            self._file.write_text(text + "\n", encoding="utf-8")
            vehicle_table.write()


def _place(line: tuple[str, ...]) -> tuple[str, int]:
    return line[0], vehicle_table.JOBS.index(line[2])
