"""Commands that make a drone fly, and how dronectl ends."""

import asyncio
import functools
import json
import os
import signal
from typing import Any

import pytest
from fake_server import FakeServer, Members, command, drone, problem, run

from dronemap import AnswerLost


@pytest.fixture
def server() -> FakeServer:
    return FakeServer(drones=[drone()])


def obeys(server: FakeServer, given: Members) -> None:
    """Arrives as soon as it is told."""
    place = server.drones[0]["position"]
    match given["type"]:
        case "takeOff":
            server.fly(flight="inAir", position=place | {"altitudeAboveHome": given["altitude"]})
        case "goTo":
            to = {"latitude": given["latitude"], "longitude": given["longitude"]}
            server.fly(flight="inAir", position=place | to | {"altitudeAboveHome": given["altitude"]})
        case "land" | "returnToLaunch":
            server.fly(flight="onGround")


@pytest.mark.parametrize(
    ("args", "kind"),
    [
        (["arm"], "arm"),
        (["disarm"], "disarm"),
        (["hold"], "hold"),
        (["mode", "LOITER"], "setMode"),
        (["takeoff", "10"], "takeOff"),
        (["goto", "-33.5", "-70.25", "20"], "goTo"),
        (["land"], "land"),
        (["rtl"], "returnToLaunch"),
    ],
)
def test_command_is_given_and_its_end_told(server: FakeServer, args: list[str], kind: str) -> None:
    server.on_command = obeys
    result = run(server, *args)
    assert (result.exit_code, result.stderr) == (0, "")
    assert [given["type"] for given in server.commands()] == [kind]
    assert result.stdout.startswith("Heron-1")


def test_places_to_the_south_and_west_are_no_options(server: FakeServer) -> None:
    run(server, "goto", "-33.5", "-70.25", "20", "--no-wait", "--amsl")
    given = server.commands()[0]
    assert (given["latitude"], given["longitude"], given["altitude"]) == (-33.5, -70.25, 20)
    assert given["altitudeReference"] == "amsl"


def test_json_is_the_command_of_the_contract(server: FakeServer) -> None:
    answered = json.loads(run(server, "hold", "--json").stdout)
    assert answered == command("hold", id=server.commands()[0]["id"])


@pytest.mark.parametrize("args", [["arm"], ["takeoff", "10"], ["goto", "1", "2", "3"], ["land"], ["rtl"], ["hold"]])
def test_refusal_is_one_sentence_with_its_code(server: FakeServer, args: list[str]) -> None:
    server.answers["POST /drones/d1/commands"] = lambda asked: problem(
        409, "It is already in the air.", "drone-airborne", commandId="command-1"
    )
    result = run(server, *args)
    assert result.exit_code == 1
    assert result.stdout == ""
    assert result.stderr.endswith("It is already in the air. [drone-airborne]\n")
    assert len(result.stderr.splitlines()) == 1


@pytest.mark.parametrize(
    ("end", "code"),
    [("refused", 1), ("failed", 1), ("timedOut", 1), ("superseded", 1), ("unknown", 3)],
)
def test_code_tells_how_the_command_ended(server: FakeServer, end: str, code: int) -> None:
    server.answers["POST /drones/d1/commands"] = lambda asked: command("arm", id=asked.body["id"], result=end)
    assert run(server, "arm").exit_code == code


def test_lost_answer_is_not_known(server: FakeServer) -> None:
    server.answers["POST /drones/d1/commands"] = AnswerLost("The connection ended before the answer came.")
    result = run(server, "arm", "--timeout", "0.1")
    assert result.exit_code == 3


def test_server_that_is_away(server: FakeServer) -> None:
    server.away = True
    result = run(server, "arm", "--timeout", "0.1")
    assert result.exit_code == 4
    assert "dronectl config" in result.stderr


@pytest.mark.parametrize("args", [["takeoff"], ["takeoff", "high"], ["goto", "1", "2", "3", "--fast"], ["nonsense"]])
def test_wrong_use_is_one_sentence(server: FakeServer, args: list[str]) -> None:
    result = run(server, *args)
    assert result.exit_code == 2
    assert len(result.stderr.splitlines()) == 1
    assert "--help" in result.stderr
    assert server.asked == []


def test_one_of_several_drones_has_to_be_named(server: FakeServer) -> None:
    server.drones.append(drone("d2", "Heron-2"))
    result = run(server, "arm")
    assert result.exit_code == 2
    assert "Heron-1, Heron-2" in result.stderr
    assert run(server, "arm", "--drone", "Heron-1").exit_code == 0
    assert run(server, "arm", "--drone", "d1").exit_code == 0
    assert run(server, "arm", "--drone", "Stork").exit_code == 1


def test_replayed_drone_is_not_meant_where_a_real_one_has_the_name(server: FakeServer) -> None:
    server.drones.append(drone("d2", "Heron-1", replay=True))
    assert run(server, "arm").exit_code == 0
    assert run(server, "arm", "--drone", "Heron-1").exit_code == 0
    assert len(server.commands()) == 2


def test_two_drones_of_one_name_are_told_apart_by_id(server: FakeServer) -> None:
    server.drones.append(drone("d2", "Heron-1"))
    result = run(server, "arm", "--drone", "Heron-1")
    assert result.exit_code == 2
    assert "d1, d2" in result.stderr


def test_command_is_given_where_the_stream_cannot_be_reached(
    server: FakeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("dronectl.settings._STREAM_SECONDS", 0.05)
    server.mute = True
    assert run(server, "hold").exit_code == 0
    result = run(server, "takeoff", "10")
    assert result.exit_code == 3
    assert "whether it arrives cannot be seen" in result.stderr
    assert [given["type"] for given in server.commands()] == ["hold", "takeOff"]


def test_line_tells_how_far_it_is_where_somebody_looks(server: FakeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("COLUMNS", "120")

    def climbs(server: FakeServer, given: Members) -> None:
        for step in range(1, 5):
            position = server.drones[0]["position"] | {"altitudeAboveHome": 2.5 * step}
            climbed = functools.partial(server.fly, flight="inAir", position=position)
            asyncio.get_running_loop().call_later(0.15 * step, climbed)

    server.on_command = climbs
    result = run(server, "takeoff", "10")
    assert "Heron-1: GUIDED, 5.0 m" in result.stderr
    assert "GUIDED, 5.0 m" not in run(server, "takeoff", "10", "--json").stderr


def test_changes_the_mode_first_where_the_vehicle_wants_that(server: FakeServer) -> None:
    server.drones[0]["actions"] = {"arm": {"allowed": True, "mode": "GUIDED"}}
    assert run(server, "arm").exit_code == 0
    assert [given["type"] for given in server.commands()] == ["setMode", "arm"]


def test_warning_is_told(server: FakeServer) -> None:
    server.answers["POST /drones/d1/commands"] = lambda asked: command(
        "goTo", id=asked.body["id"], warnings=["It is 9 km away."]
    )
    assert "It is 9 km away." in run(server, "goto", "1", "2", "3", "--no-wait").stderr


def test_timeout_leaves_the_drone_alone(server: FakeServer) -> None:
    result = run(server, "takeoff", "10", "--timeout", "0.3")
    assert result.exit_code == 3
    assert "goes on" in result.stderr
    assert [given["type"] for given in server.commands()] == ["takeOff"]


def interrupts(server: FakeServer, given: Members) -> None:
    """Ctrl-C as soon as the command has come."""
    if given["type"] != "hold":
        os.kill(os.getpid(), signal.SIGINT)


@pytest.mark.parametrize("args", [["takeoff", "10"], ["goto", "1", "2", "3"]])
def test_interrupted_on_the_way_holds_once(server: FakeServer, args: list[str]) -> None:
    server.on_command = interrupts
    result = run(server, *args)
    assert result.exit_code == 130
    assert [given["type"] for given in server.commands()][1:] == ["hold"]
    assert "Heron-1 holds where it is" in result.stderr


@pytest.mark.parametrize("args", [["land"], ["rtl"]])
def test_interrupted_on_the_way_down_goes_on(server: FakeServer, args: list[str]) -> None:
    server.drones = [drone(flight="inAir")]
    server.on_command = interrupts
    result = run(server, *args)
    assert result.exit_code == 130
    assert len(server.commands()) == 1
    assert "Heron-1 goes on" in result.stderr


def test_drone_that_cannot_be_told_to_hold(server: FakeServer) -> None:
    def answer(asked: Any) -> Any:
        if asked.body["type"] == "hold":
            return problem(409, "Somebody else has control.", "control-held", commandId="c")
        interrupts(server, asked.body)
        return command("takeOff", id=asked.body["id"])

    server.answers["POST /drones/d1/commands"] = answer
    result = run(server, "takeoff", "10")
    assert result.exit_code == 130
    assert "may fly on" in result.stderr
    assert "Somebody else has control." in result.stderr
