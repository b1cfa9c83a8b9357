"""Results of a trial: one line a unit in .tools/trials, and the same for readers in docs/trials."""

import os
import zlib
from dataclasses import dataclass, field
from pathlib import Path

from trial_table import Trial

COLUMNS = ("unit", "result", "seconds", "load before", "load", "cores", "commit", "processor")


@dataclass(frozen=True)
class UnitResult:
    """One unit that ran to its end."""

    unit: str
    result: str
    seconds: str
    load_before: str
    load: str
    cores: str
    commit: str
    processor: str

    def line(self) -> str:
        values = (self.unit, self.result, self.seconds, self.load_before, self.load, self.cores)
        return "\t".join((*values, self.commit, self.processor))

    @property
    def passed(self) -> bool:
        return self.result == "passed"


@dataclass
class TrialState:
    """Results of a trial so far. A line that is damaged, or of another command, counts for nothing."""

    trial: Trial
    root: Path
    finished: dict[str, UnitResult] = field(default_factory=dict)
    damaged_lines: list[str] = field(default_factory=list)

    @property
    def file(self) -> Path:
        return self.root / ".tools" / "trials" / f"{self.trial.name}.tsv"

    @property
    def results(self) -> Path:
        return self.root / "docs" / "trials" / f"{self.trial.name}.tsv"

    @property
    def missing(self) -> list[str]:
        return [unit for unit in self.trial.units if unit not in self.finished]

    @property
    def failed(self) -> int:
        return sum(not one.passed for one in self.finished.values())

    def checksum(self, line: str) -> str:
        return f"{zlib.crc32(f'{self.trial.run} {self.trial.busy} {line}'.encode()):08x}"

    def read(self) -> "TrialState":
        lines = self.file.read_bytes().split(b"\n") if self.file.exists() else []
        for number, raw in enumerate(lines, 1):
            if not raw:
                continue
            line, _, check = raw.decode(errors="replace").rpartition("\t")
            values = line.split("\t")
            if len(values) != len(COLUMNS) or check != self.checksum(line) or values[0] in self.finished:
                sentence = (
                    f"Line {number} of {self.file} is damaged, or of another command, and counts for nothing"
                )
                self.damaged_lines.append(f"{sentence}: {raw[:60].decode(errors='replace')}")
            elif values[0] in self.trial.units:
                self.finished[values[0]] = UnitResult(*values)
        return self

    def add(self, one: UnitResult) -> None:
        self.finished[one.unit] = one
        done = [self.finished[unit] for unit in self.trial.units if unit in self.finished]
        replace(
            self.file, "".join(f"{line}\t{self.checksum(line)}\n" for line in (one.line() for one in done))
        )
        self.publish()

    def publish(self) -> None:
        done = [self.finished[unit] for unit in self.trial.units if unit in self.finished]
        busy = f", beside {self.trial.busy} busy process(es)" if self.trial.busy else ""
        head = [
            f"# {self.trial.name}: {self.trial.description}",
            f"# each unit: {self.trial.run}{busy}",
            f"# {len(done)} of {len(self.trial.units)} units done, {self.failed} failed",
            "\t".join(COLUMNS),
        ]
        replace(self.results, "\n".join([*head, *(one.line() for one in done)]) + "\n")

    def discard(self) -> None:
        for file in (self.file, self.results):
            file.unlink(missing_ok=True)
        self.finished, self.damaged_lines = {}, []

    def progress(self) -> str:
        failed = f", {self.failed} failed" if self.failed else ""
        return f"{len(self.finished)} of {len(self.trial.units)}{failed}"


def replace(file: Path, text: str) -> None:
    """All of it or nothing, whenever the process or the machine ends."""
    file.parent.mkdir(parents=True, exist_ok=True)
    new = file.with_suffix(".new")
    with new.open("w", encoding="utf-8") as output:
        output.write(text)
        output.flush()
        os.fsync(output.fileno())
    new.replace(file)
