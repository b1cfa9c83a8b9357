"""What is printed: tables for people, JSON for programs, and a line on stderr about what goes on."""

import json
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from datetime import datetime
from pathlib import Path
from typing import Any

from pydantic import BaseModel
from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TaskID, TextColumn, TimeElapsedColumn
from rich.table import Table

#: A table that goes into a file or a pipe is not cut to the width of a terminal.
_WIDE = 250
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")


def members(value: BaseModel) -> Any:
    """The object of the contract, with the members that the server sent and the names that it uses."""
    return value.model_dump(mode="json", by_alias=True, exclude_unset=True)


def table(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> Table:
    """A table without lines; what is None is left empty."""
    drawn = Table(box=None, pad_edge=False, header_style="bold")
    for column in columns:
        drawn.add_column(column, overflow="fold")
    for row in rows:
        drawn.add_row(*(text(cell) for cell in row))
    return drawn


def plain(words: str) -> str:
    """Without control characters: what a vehicle says must not steer the terminal."""
    return _CONTROL.sub("\N{REPLACEMENT CHARACTER}", words)


def text(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.1f}"
    if isinstance(value, datetime):
        return f"{value.astimezone():%Y-%m-%d %H:%M:%S}"
    return plain(str(value))


def place(latitude: float | None, longitude: float | None) -> str:
    return "" if latitude is None or longitude is None else f"{latitude:.6f}, {longitude:.6f}"


class Working:
    """A line on stderr that tells how far something is; nothing where nobody looks at it."""

    def __init__(self, progress: Progress, task: TaskID) -> None:
        self._progress = progress
        self._task = task

    def say(self, words: str, done: float | None = None, total: float | None = None) -> None:
        """`done` of `total` is drawn as a bar."""
        self._progress.update(self._task, description=plain(words), completed=done, total=total)


class Output:
    """Where a command prints: results on stdout, all else on stderr."""

    def __init__(self, as_json: bool) -> None:
        self.as_json = as_json
        self.console = _console(sys.stdout)
        self.errors = _console(sys.stderr)

    def show(self, answer: BaseModel, drawn: Table | str) -> None:
        """The answer itself with --json, else as it is drawn for people."""
        if self.as_json:
            self.json(members(answer))
        else:
            self.draw(drawn)

    def draw(self, drawn: Table | str) -> None:
        if self.console.is_terminal or isinstance(drawn, str):
            self.console.print(plain(drawn) if isinstance(drawn, str) else drawn, soft_wrap=isinstance(drawn, str))
            return
        with self.console.capture() as capture:
            self.console.print(drawn)
        # Rich fills each line up to the width of the table.
        for line in capture.get().splitlines():
            self._write(line.rstrip())

    def json(self, value: Any) -> None:
        self._write(json.dumps(value, indent=2, ensure_ascii=False))

    def json_line(self, value: BaseModel) -> None:
        """One object a line, at once: for programs that read along."""
        self._write(json.dumps(members(value), ensure_ascii=False, separators=(",", ":")))

    def say(self, words: str) -> None:
        """For people only."""
        if not self.as_json:
            self.console.print(plain(words), soft_wrap=True)

    def note(self, words: str) -> None:
        """On stderr, with --json too: what must not be overlooked."""
        self.errors.print(plain(words), soft_wrap=True)

    @contextmanager
    def working(self, words: str) -> Iterator[Working]:
        progress = Progress(
            SpinnerColumn(),
            TextColumn("{task.description}", markup=False),
            BarColumn(bar_width=24),
            TimeElapsedColumn(),
            console=self.errors,
            transient=True,
        )
        looked_at = self.errors.is_terminal and not self.as_json
        with progress if looked_at else nullcontext():
            yield Working(progress, progress.add_task(words, total=None))

    def write(self, content: bytes) -> None:
        """As it is, for a pipe or a file."""
        sys.stdout.flush()
        sys.stdout.buffer.write(content)
        sys.stdout.buffer.flush()

    def save(self, content: bytes, file: Path) -> None:
        """Whole or not at all: what was there before stays until all of it is written."""
        part = file.with_name(f"{file.name}.part")
        try:
            part.write_bytes(content)
            part.replace(file)
        finally:
            part.unlink(missing_ok=True)
        self.note(f"{file}: {len(content)} bytes.")

    def _write(self, line: str) -> None:
        sys.stdout.write(f"{line}\n")
        sys.stdout.flush()


def _console(stream: Any) -> Console:
    # What a vehicle or user calls itself is text, not markup.
    console = Console(file=stream, markup=False, highlight=False, emoji=False)
    if not console.is_terminal:
        console = Console(file=stream, markup=False, highlight=False, emoji=False, width=_WIDE)
    return console
