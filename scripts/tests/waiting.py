"""Waits of tests for what other processes do."""

import time
from collections.abc import Callable

PATIENCE_SECONDS = 60
BETWEEN_LOOKS_SECONDS = 0.02


def until(what: str, holds: Callable[[], bool], seconds: float = PATIENCE_SECONDS) -> None:
    deadline = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < deadline, f"Not within {seconds} s: {what}"
        time.sleep(BETWEEN_LOOKS_SECONDS)
