"""A database that halts now and then: what was decided waits to be written, and is sent only then."""

import os
import random
import signal
import threading
from contextlib import suppress
from pathlib import Path
from types import TracebackType

LONGEST_SECONDS = 0.08
LONGEST_BETWEEN_SECONDS = 0.15


class DatabaseStall:
    """Stops and continues the processes of a server's own database at random while it is entered."""

    def __init__(self, data: Path, seed: int) -> None:
        self._cluster = data / "postgres" / "cluster"
        self._chance = random.Random(seed)
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.times = 0

    def __enter__(self) -> "DatabaseStall":
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._over.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._over.wait(self._chance.random() * LONGEST_BETWEEN_SECONDS):
            halted = [process for process in self._processes() if _signal(process, signal.SIGSTOP)]
            self._over.wait(self._chance.random() * LONGEST_SECONDS)
            for process in halted:
                _signal(process, signal.SIGCONT)
            self.times += bool(halted)

    def _processes(self) -> list[int]:
        """Processes that serve connections; none while the database is down."""
        with suppress(OSError, ValueError, IndexError):
            first = int((self._cluster / "postmaster.pid").read_text().splitlines()[0])
            children = Path(f"/proc/{first}/task/{first}/children").read_text().split()
            return [int(child) for child in children if _serves(int(child))]
        return []


def _serves(process: int) -> bool:
    with suppress(OSError):
        return b"127.0.0.1" in Path(f"/proc/{process}/cmdline").read_bytes()
    return False


def _signal(process: int, what: signal.Signals) -> bool:
    with suppress(ProcessLookupError):
        os.kill(process, what)
        return True
    return False
