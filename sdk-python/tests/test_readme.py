"""The programs of README.md run as they stand, before a server in memory."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from dronemap import Dronemap
from dronemap.testing import MockTransport

README = (Path(__file__).parents[1] / "README.md").read_text()
PROGRAMS = re.findall(r"^## ([^\n]+)\n(?:(?!^## ).)*?^```python\n(.*?)^```", README, re.MULTILINE | re.DOTALL)
PLAN: dict[str, Any] = {
    **{"id": "p", "by": "ann", "askedAt": "2026-01-01T00:00:00Z", "drones": [], "seconds": 2.0, "seed": 1},
    **{"state": "finished", "waypoints": 8},
}
RUN: dict[str, Any] = {
    **{"id": "r", "name": "Run", "owner": "ann", "mode": "automatic", "onCloudLoss": "continue", "journal": 1},
    **{"state": "over", "beganAt": "2026-01-01T00:00:00Z", "barriers": [], "drones": [], "explanations": []},
    **{
        "waypoints": [],
        "counts": {"cancelled": 0, "doubles": 0, "replans": 0, "unserved": 0, "visited": 8, "waypoints": 8},
    },
}


@pytest.fixture
def connected(monkeypatch: pytest.MonkeyPatch) -> MockTransport:
    mock = MockTransport()
    home = {"latitude": 47.3977, "longitude": 8.5456, "altitudeAmsl": 488.0}
    id = mock.add_drone("ArduCopter 1", home=home)
    mock.add_drone("ArduCopter 2", home=home)
    mock.answer("POST", "/plans", PLAN, 202)
    mock.answer("GET", "/plans/p", PLAN)
    mock.answer("POST", "/runs", RUN, 201)
    mock.answer("GET", "/runs/r", RUN)
    points = {"drone": id, "from": "2026-01-01T00:00:00Z", "until": "2026-01-01T01:00:00Z", "points": []}
    mock.answer("GET", f"/drones/{id}/telemetry/points", points)
    connect: Callable[..., Dronemap] = Dronemap.connect
    monkeypatch.setattr(Dronemap, "connect", lambda transport=mock: connect(transport=transport))
    return mock


def test_readme_has_programs() -> None:
    assert len(PROGRAMS) >= 6


@pytest.mark.parametrize("program", [pytest.param(text, id=title) for title, text in PROGRAMS])
def test_program_of_the_readme_runs(program: str, connected: MockTransport) -> None:
    exec(compile(program, "README.md", "exec"), {})
    assert connected.requests or "MockTransport" in program


def test_first_flight_is_short_and_flies() -> None:
    lines = [line for line in PROGRAMS[0][1].splitlines() if line.strip()]
    assert len(lines) <= 8
    assert "take_off" in PROGRAMS[0][1] and "go_to" in PROGRAMS[0][1]
