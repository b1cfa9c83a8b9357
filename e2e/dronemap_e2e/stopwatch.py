"""Limits that are promised for a machine at rest, asked for fairly on one that is busy."""

import os
import subprocess
import sys
import time

STEPS = 3_000_000
# What the steps take on a machine of today that has nothing else to do, with the start of the interpreter.
STEPS_SECONDS = 0.25
WORK = f"total = 0\nfor step in range({STEPS}):\n    total += step"


def slowness() -> float:
    """How many times as long as at rest pieces of work take just now, one on each core; at least 1."""
    began = time.monotonic()
    workers = [subprocess.Popen([sys.executable, "-S", "-c", WORK]) for _ in range(os.cpu_count() or 1)]
    for worker in workers:
        assert worker.wait() == 0
    return max(1.0, (time.monotonic() - began) / STEPS_SECONDS)


class Stopwatch:
    """Runs from its making on. Waiting itself has a deadline of its own, long enough for a slow machine."""

    def __init__(self) -> None:
        self._slowness = slowness()
        self._began = time.monotonic()

    def expect_at_most(self, seconds: float) -> None:
        """Not more has gone by than promised; on a busy machine, than promised times its slowness."""
        took = time.monotonic() - self._began
        factor = max(self._slowness, slowness())
        assert took <= seconds * factor, (
            f"{took:.1f} s instead of {seconds:g} s (the machine is {factor:.1f} times slower)"
        )
