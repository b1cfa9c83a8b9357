"""Waiting for conditions, never for time alone."""

import time
from collections.abc import Callable, Iterator
from typing import TypeVar

T = TypeVar("T")


def wait_for(what: str, condition: Callable[[], T | None], seconds: float = 30.0, every: float = 0.1) -> T:
    """The first truthy answer; after the deadline an AssertionError that says what was missing."""
    deadline = time.monotonic() + seconds
    while True:
        answer = condition()
        if answer:
            return answer
        assert time.monotonic() < deadline, f"not within {seconds:.0f} s: {what}"
        time.sleep(every)


def throughout(what: str, condition: Callable[[], object], seconds: float, every: float = 0.1) -> None:
    """Holds at every look for so long: for what stays as it is, where there is no event to wait for."""
    end = time.monotonic() + seconds
    while True:
        assert condition(), f"not all along: {what}"
        if time.monotonic() >= end:
            return
        time.sleep(every)


def rounds(until: float, every: float) -> Iterator[None]:
    """A turn every so often up to a moment (monotonic s): for what is done while something else goes on."""
    while time.monotonic() < until:
        yield
        time.sleep(every)
