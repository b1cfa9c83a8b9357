"""A server in memory, and a client of it."""

import signal
from collections.abc import Iterator

import pytest

from dronemap import Dronemap
from dronemap.testing import MockTransport


@pytest.fixture(scope="session", autouse=True)
def interruptible() -> Iterator[None]:
    """A shell lets what it runs in the background ignore interruptions, and tests would inherit that."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def mock() -> MockTransport:
    return MockTransport()


@pytest.fixture
def server(mock: MockTransport) -> Iterator[Dronemap]:
    with Dronemap.connect(transport=mock, patience=2) as connected:
        yield connected
