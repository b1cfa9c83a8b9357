"""All operations of the contract have a command, or a reason why not, and can be called."""

import inspect
import json
from pathlib import Path
from typing import Any

import click
import pytest
from fake_server import FakeServer, drone, run

from dronectl.call import _snake
from dronectl.operations import COMMANDS, LEFT_OUT
from dronectl.tree import cli
from dronectl.users import ROLES
from dronemap.contract import models
from dronemap.contract.operations import Operations

WIRE = Path(__file__).parents[3] / "dronemap-ws" / "src" / "test" / "resources" / "wire" / "openapi.json"


def contract() -> set[str]:
    paths: dict[str, dict[str, Any]] = json.loads(WIRE.read_text())["paths"]
    return {
        operation["operationId"]
        for path in paths.values()
        for operation in path.values()
        if isinstance(operation, dict) and "operationId" in operation
    }


@pytest.fixture
def server() -> FakeServer:
    return FakeServer(drones=[drone()])


def test_each_operation_has_a_command_or_a_reason_why_not() -> None:
    missing = contract() - set(COMMANDS) - set(LEFT_OUT)
    assert not missing, f"Name them in dronectl/operations.py: {sorted(missing)}"
    assert not (set(COMMANDS) | set(LEFT_OUT)) - contract()
    assert not set(COMMANDS) & set(LEFT_OUT)


@pytest.mark.parametrize("path", sorted(set(COMMANDS.values())))
def test_command_of_an_operation_exists(path: str) -> None:
    found: click.Command = cli
    for word in path.split():
        assert isinstance(found, click.Group)
        found = found.commands[word]
    assert not isinstance(found, click.Group)


@pytest.mark.parametrize("operation", sorted(contract()))
def test_each_operation_can_be_called_by_its_name(operation: str) -> None:
    assert inspect.iscoroutinefunction(getattr(Operations, _snake(operation)))


def commands(group: click.Group, path: str) -> list[tuple[str, click.Command]]:
    found: list[tuple[str, click.Command]] = []
    for name, command in group.commands.items():
        if isinstance(command, click.Group):
            found += commands(command, f"{path}{name} ")
        else:
            found.append((f"{path}{name}", command))
    return found


@pytest.mark.parametrize(("path", "command"), commands(cli, ""))
def test_command_explains_itself_and_takes_the_options_of_all(
    server: FakeServer, path: str, command: click.Command
) -> None:
    result = run(server, *path.split(), "--help")
    assert result.exit_code == 0
    assert command.help
    for option in ("--url", "--key-file", "--profile", "--json", "--timeout"):
        assert option in result.stdout
    assert server.asked == []
    # A key would be read by all who list processes.
    assert "--key " not in result.stdout


def test_roles_are_those_of_the_contract() -> None:
    schema = models.NewUser.model_json_schema()["properties"]["role"]
    assert tuple(schema["anyOf"][0]["enum"]) == ROLES


def test_call_takes_parameters_and_prints_the_answer(server: FakeServer) -> None:
    server.answers["GET /drones/d1/events"] = {
        "drone": "d1",
        "events": [],
        "from": "2026-03-04T05:06:07Z",
        "until": "2026-03-04T05:06:07Z",
        "more": False,
    }
    result = run(server, "call", "listDroneEvents", "id=d1", "from=2026-03-04T05:06:07Z", "most=7")
    assert json.loads(result.stdout) == server.answers["GET /drones/d1/events"]
    assert server.last("GET", "/drones/d1/events").query == {"from": "2026-03-04T05:06:07Z", "most": "7"}


def test_call_sends_a_body(server: FakeServer) -> None:
    server.answers["PATCH /drones/d1"] = server.drones[0]
    server.answers["PUT /drones/d1"] = server.drones[0]
    result = run(server, "call", "renameDrone", "id=d1", "--body", "-", input='{"name": "Stork"}')
    assert result.exit_code == 0, result.stderr
    assert server.asked[-1].body == {"name": "Stork"}


def test_call_sends_a_body_of_bytes_as_it_is(server: FakeServer) -> None:
    server.answers["POST /replays"] = None
    run(server, "call", "startReplay", "speed=2", "--body", "-", input="tlog")
    assert server.last("POST", "/replays").content == b"tlog"
    assert server.last("POST", "/replays").query == {"speed": "2.0"}


def test_call_writes_bytes_as_they_are(server: FakeServer, tmp_path: Path) -> None:
    server.answers["GET /recordings/r1/file"] = b"\0\1"
    assert run(server, "call", "getRecordingFile", "id=r1").stdout_bytes == b"\0\1"
    file = tmp_path / "a.tlog"
    assert run(server, "call", "getRecordingFile", "id=r1", "--output", str(file)).exit_code == 0
    assert file.read_bytes() == b"\0\1"


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("nonsense", "no operation 'nonsense'"),
        ("getDrone", "needs id="),
        ("getDrone d1", "is no PARAMETER=VALUE"),
        ("getDrone name=d1", "it has id"),
        ("getDrone id=d1 --body -", "takes no --body"),
        ("renameDrone id=d1", "needs --body FILE"),
        ("listDrones active=perhaps", "active"),
        ("listDrones --fast", "No such option"),
    ],
)
def test_call_that_is_wrong(server: FakeServer, line: str, why: str) -> None:
    result = run(server, "call", *line.split(), input="{}")
    assert result.exit_code == 2
    assert why in result.stderr
    assert server.asked == []


def test_body_with_a_member_that_there_is_not(server: FakeServer) -> None:
    result = run(server, "call", "renameDrone", "id=d1", "--body", "-", input='{"nam": "Stork"}')
    assert result.exit_code == 2
    assert "nam" in result.stderr
    assert server.asked == []


def test_operations_are_listed(server: FakeServer) -> None:
    listed = run(server, "operations").stdout
    assert "dronectl mission save" in listed
    assert "call only: for browsers" in listed
    assert set(json.loads(run(server, "operations", "--json").stdout)["commands"]) == set(COMMANDS)
