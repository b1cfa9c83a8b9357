"""Events that are followed: in order, over cuts, and with what is missing told."""

import json
import os
import signal
from pathlib import Path
from typing import Any

import pytest
from fake_server import NOW, Asked, FakeServer, Members, drone, run

FIRST: Members = {"number": 1, "drone": "d1", "at": NOW, "kind": "armed", "text": "Armed."}
GAP: Members = {"after": 1, "cause": "serverEnded", "text": "The server ended before it wrote them."}
LAST: Members = {"number": 9, "drone": "d1", "at": NOW, "kind": "disarmed", "text": "Disarmed."}


@pytest.fixture
def server() -> FakeServer:
    server = FakeServer(drones=[drone()])
    server.answers["GET /events"] = pages
    return server


def pages(asked: Asked) -> Any:
    """Two events and a gap after the beginning, and then Ctrl-C."""
    match asked.query.get("after"):
        case None:
            return {"events": [], "gaps": [], "next": "now"}
        case "now" | "first":
            return {"events": [FIRST, LAST], "gaps": [GAP], "next": "later"}
        case _:
            os.kill(os.getpid(), signal.SIGINT)
            return {"events": [], "gaps": [], "next": "later"}


def test_tells_events_and_what_is_missing(server: FakeServer) -> None:
    result = run(server, "events", "follow", "Heron-1")
    assert result.exit_code == 130
    assert [line.split(" ", 2)[2] for line in result.stdout.splitlines()] == ["Heron-1 Armed.", "Heron-1 Disarmed."]
    assert "The server ended before it wrote them." in result.stderr
    assert "--after later" in result.stderr
    assert server.last("GET", "/events").query["drones"] == "d1"


def test_json_is_one_object_a_line_in_order(server: FakeServer) -> None:
    lines = run(server, "events", "follow", "--json", "--after", "first").stdout.splitlines()
    assert [json.loads(line) for line in lines] == [FIRST, GAP, LAST]


def test_goes_on_from_the_file_where_it_was_read_to(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "cursor"
    run(server, "events", "follow", "--cursor", str(file))
    assert file.read_text() == "later\n"
    server.asked.clear()
    run(server, "events", "follow", "--cursor", str(file))
    assert next(asked for asked in server.asked if asked.path == "/events").query["after"] == "later"


def test_drone_that_there_is_not(server: FakeServer) -> None:
    result = run(server, "events", "follow", "Stork")
    assert result.exit_code == 1
    assert "there are: Heron-1" in result.stderr
