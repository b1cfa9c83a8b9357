"""Limits that are promised for a machine at rest, asked for fairly on one that is busy."""

import os
import statistics
import subprocess
import sys
import threading
import time
from pathlib import Path

STEPS = 3_000_000
# What the steps take on a machine of today that has nothing else to do, with the start of the interpreter.
STEPS_SECONDS = 0.25
WORK = f"total = 0\nfor step in range({STEPS}):\n    total += step"


def slowness() -> float:
    """Factor by which work takes longer now than at rest, one piece on each core; at least 1."""
    began = time.monotonic()
    workers = [subprocess.Popen([sys.executable, "-S", "-c", WORK]) for _ in range(os.cpu_count() or 1)]
    for worker in workers:
        assert worker.wait() == 0
    return max(1.0, (time.monotonic() - began) / STEPS_SECONDS)


class CoreLoad:
    """Measures how many threads of the machine wanted a core at once, on average since its making."""

    def __init__(self) -> None:
        self._samples: list[int] = []
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        while not self._over.wait(0.1):
            self._samples.append(running())

    def per_core(self) -> float:
        self._over.set()
        self._thread.join()
        return statistics.fmean(self._samples or [0]) / (os.cpu_count() or 1)


def running() -> int:
    """Threads that run or could run at this moment."""
    for line in Path("/proc/stat").read_text().splitlines():
        name, _, value = line.partition(" ")
        if name == "procs_running":
            return int(value)
    raise AssertionError("/proc/stat does not tell what runs")


class Stopwatch:
    """Runs from its making on. Waiting itself has a deadline of its own, long enough for a slow machine."""

    def __init__(self) -> None:
        self._slowness = slowness()
        self._load = CoreLoad()
        self._began = time.monotonic()

    def expect_at_most(self, seconds: float) -> None:
        """Not more has gone by than promised; on a busy machine, than promised times its slowness."""
        took = time.monotonic() - self._began
        factor = max(self._slowness, self._load.per_core(), slowness())
        assert took <= seconds * factor, (
            f"{took:.1f} s instead of {seconds:g} s (the machine is {factor:.1f} times slower)"
        )
