"""A server in memory, and a client of it."""

from collections.abc import Iterator

import pytest

from dronemap import Dronemap
from dronemap.testing import MockTransport


@pytest.fixture
def mock() -> MockTransport:
    return MockTransport()


@pytest.fixture
def server(mock: MockTransport) -> Iterator[Dronemap]:
    with Dronemap.connect(transport=mock, patience=2) as connected:
        yield connected
