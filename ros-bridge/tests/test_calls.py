"""Services that are called beside what must not wait."""

import threading

import pytest

from roslink_bridge.calls import MOST_WAITING, ServiceCalls


class RefusedError(Exception):
    pass


def test_service_calls_are_sequential_and_overflow_is_dropped(caplog: pytest.LogCaptureFixture) -> None:
    calls = ServiceCalls((RefusedError,))
    begun, go_on, done = threading.Event(), threading.Event(), threading.Event()
    order = []

    def slow() -> bool:
        begun.set()
        return go_on.wait(10)

    def finish() -> bool:
        done.set()
        return True

    def fails() -> bool:
        order.append("fails")
        raise RefusedError("nobody there")

    calls.ask("slow", slow)
    assert begun.wait(10)
    calls.ask("arming", fails)
    calls.ask("landing", lambda: order.append("lands"))
    calls.ask("last", finish)
    for _ in range(MOST_WAITING):
        calls.ask("too much", lambda: True)
    assert calls.dropped == MOST_WAITING - 1
    go_on.set()
    assert done.wait(10)

    assert order == ["fails", "lands"]
    assert "no answer about arming: nobody there" in caplog.text
    assert "refuses landing" in caplog.text
