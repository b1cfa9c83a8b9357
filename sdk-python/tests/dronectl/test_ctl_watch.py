"""What goes on for a while: watched drones, plans, runs and follows."""

import asyncio
import json
import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import contract_samples as samples
import pytest
from fake_server import Asked, FakeServer, Members, drone, problem, run


@pytest.fixture
def server() -> FakeServer:
    return FakeServer(drones=[drone(), drone("d2", "Heron-2")])


def soon(act: Callable[[], None]) -> Callable[[Asked], Members]:
    """An answer of settings, after which that happens."""

    def answer(asked: Asked) -> Members:
        asyncio.get_running_loop().call_later(0.1, act)
        return {"publicMode": False, "streamPort": 1, "version": "0.9"}

    return answer


def test_watch_prints_a_line_for_what_changes(server: FakeServer) -> None:
    server.answers["GET /settings"] = soon(lambda: server.fly(mode="LOITER"))
    result = run(server, "watch", "--timeout", "0.4")
    assert result.exit_code == 0
    lines = [line.split(" ", 1)[1] for line in result.stdout.splitlines()]
    assert lines == [
        "Heron-1 live onGround disarmed GUIDED",
        "Heron-2 live onGround disarmed GUIDED",
        "Heron-1 live onGround disarmed LOITER",
    ]


def test_watch_of_one_drone_as_json(server: FakeServer) -> None:
    server.answers["GET /settings"] = soon(lambda: server.fly(mode="LOITER"))
    result = run(server, "watch", "Heron-1", "--json", "--timeout", "0.4")
    told = [json.loads(line) for line in result.stdout.splitlines()]
    assert [state["mode"] for state in told] == ["GUIDED", "LOITER"]
    assert {state["id"] for state in told} == {"d1"}
    assert told[-1] == server.drones[0]


def test_watch_at_a_terminal_is_a_table(server: FakeServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("COLUMNS", "150")
    server.answers["GET /settings"] = soon(lambda: server.fly(mode="LOITER"))
    printed = run(server, "watch", "Heron-1", "--timeout", "0.8").stdout
    assert "BATTERY %" in printed
    assert "GUIDED" in printed
    assert "LOITER" in printed
    assert "Heron-2" not in printed


def test_watch_ends_with_ctrl_c(server: FakeServer) -> None:
    server.answers["GET /settings"] = soon(lambda: os.kill(os.getpid(), signal.SIGINT))
    assert run(server, "watch").exit_code == 130


def test_watch_of_a_drone_that_there_is_not(server: FakeServer) -> None:
    result = run(server, "watch", "Stork")
    assert result.exit_code == 1
    assert "there are: Heron-1, Heron-2" in result.stderr


def changed(view: Members, **members: Any) -> Members:
    copied: Members = json.loads(json.dumps(view))
    return copied | members


def test_run_is_told_of_until_it_is_over(server: FakeServer) -> None:
    running = changed(samples.RUN, state="running", end=None)
    server.answers["GET /runs/r1"] = running
    server.answers["GET /settings"] = soon(lambda: server.tell({"type": "run", "run": samples.RUN}))
    result = run(server, "run", "watch", "r1")
    assert result.exit_code == 0
    assert result.stdout.count("One drone sets off.") == 1
    assert "The run is over." in result.stdout
    lines = run(server, "run", "watch", "r1", "--json").stdout.splitlines()
    assert [json.loads(line)["state"] for line in lines] == ["running", "over"]


def test_run_that_left_waypoints_out_ends_with_a_failure(server: FakeServer) -> None:
    server.answers["GET /runs/r1"] = changed(samples.RUN, counts=samples.RUN["counts"] | {"waypoints": 3})
    result = run(server, "run", "watch", "r1")
    assert result.exit_code == 1
    assert "1 of 3 waypoints were visited" in result.stderr


def test_run_goes_on_when_the_watching_ends(server: FakeServer) -> None:
    server.answers["GET /runs/r1"] = changed(samples.RUN, state="running")
    server.answers["GET /settings"] = soon(lambda: os.kill(os.getpid(), signal.SIGINT))
    result = run(server, "run", "watch", "r1")
    assert result.exit_code == 130
    assert "dronectl run stop r1" in result.stderr
    assert all(asked.method == "GET" for asked in server.asked)


def test_plan_that_there_is_none_of(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "w.json"
    file.write_text('{"waypoints": [{"latitude": 47, "longitude": 8, "altitude": 15}], "drones": ["Heron-2"]}')
    server.answers["POST /plans"] = server.answers["GET /plans/p1"] = changed(
        samples.PLAN, state="failed", why="No drone gets there.", result=None
    )
    result = run(server, "plan", "make", str(file), "--seconds", "1", "--objective", "leastTime")
    assert result.exit_code == 1
    assert "No drone gets there." in result.stderr
    asked = server.last("POST", "/plans").body
    assert asked["drones"] == ["d2"]
    assert (asked["seconds"], asked["objective"]) == (1, {"kind": "leastTime"})


def test_plan_without_drones_is_not_asked_for(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "w.json"
    file.write_text('[{"latitude": 47, "longitude": 8, "altitude": 15}]')
    result = run(server, "plan", "make", str(file))
    assert result.exit_code == 2
    assert "--drone" in result.stderr


def test_plan_for_up_to_so_many_drones_of_the_pool(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "w.json"
    file.write_text('{"drones": ["Heron-1"], "waypoints": [{"latitude": 47, "longitude": 8, "altitude": 15}]}')
    server.answers["POST /plans"] = server.answers["GET /plans/p1"] = changed(
        samples.PLAN, state="failed", why="No drone gets there.", result=None
    )
    run(server, "plan", "make", str(file), "--up-to", "3")
    asked = server.last("POST", "/plans").body
    assert asked["upTo"] == 3
    assert asked.get("drones") is None
    both = run(server, "plan", "make", str(file), "--up-to", "3", "--drone", "Heron-1")
    assert both.exit_code == 2
    assert "either --drone or --up-to" in both.stderr


def test_accepted_plan_of_which_a_drone_failed(server: FakeServer) -> None:
    flight = {"drone": "d1", "name": "Heron-1"}
    under_way = {"underWay": True, "drones": [flight | {"stage": "uploading"}]}
    ended = {"underWay": False, "drones": [flight | {"stage": "failed", "why": "It does not answer."}]}
    server.answers["POST /plans/p1/accept"] = changed(samples.PLAN, launch=under_way)
    server.answers["GET /plans/p1"] = changed(samples.PLAN, launch=ended)
    result = run(server, "plan", "accept", "p1")
    assert result.exit_code == 1
    assert "Heron-1: It does not answer." in result.stderr


def test_virtual_mission_that_failed(server: FakeServer) -> None:
    failed = changed(samples.VIRTUAL)
    failed["run"] |= {"state": "failed", "sentence": "No drone could serve it."}
    server.answers["GET /virtual-drones"] = {"virtualDrones": [failed]}
    server.answers["GET /virtual-drones/v1"] = failed
    result = run(server, "virtual", "watch", "survey")
    assert result.exit_code == 1
    assert result.stderr == "dronectl: No drone could serve it.\n"


@pytest.fixture
def way(tmp_path: Path) -> str:
    file = tmp_path / "way.csv"
    file.write_text("latitude,longitude,seconds\n47.0,8.0,0\n47.00001,8.0,0.5\n")
    return str(file)


def followed(server: FakeServer) -> None:
    """A follow that begins when it is started, and is over when it is stopped."""
    states = {"start": "tracking", "stop": "over", "cancel": "over"}
    view = changed(samples.FOLLOW)

    def act(action: str) -> Callable[[Asked], Members]:
        def answer(asked: Asked) -> Members:
            view["state"] = states[action]
            return view

        return answer

    server.answers |= {f"POST /follows/f1/{action}": act(action) for action in states}
    server.answers |= {"POST /follows": view, "GET /follows/f1": lambda asked: view}
    server.answers["POST /follows/f1/positions"] = samples.RECEIPT


def test_way_is_walked_and_the_drone_flies_home(server: FakeServer, way: str) -> None:
    followed(server)
    result = run(server, "follow", "walk", way, "--drone", "Heron-2")
    assert result.exit_code == 0, result.stderr
    assert server.last("POST", "/follows").body["drone"] == "d2"
    assert server.last("POST", "/follows/f1/positions").body["positions"][0]["latitude"] == pytest.approx(47)
    assert server.last("POST", "/follows/f1/stop")


def test_interrupted_walk_calls_the_drone_home(server: FakeServer, way: str) -> None:
    followed(server)

    def interrupts(asked: Asked) -> Members:
        os.kill(os.getpid(), signal.SIGINT)
        return samples.RECEIPT

    server.answers["POST /follows/f1/positions"] = interrupts
    result = run(server, "follow", "walk", way)
    assert result.exit_code == 130
    assert server.last("POST", "/follows/f1/stop")


def test_walk_that_is_refused_gives_the_drone_back(server: FakeServer, way: str) -> None:
    followed(server)
    server.answers["POST /follows/f1/start"] = lambda asked: problem(409, "It cannot arm.", "drone-not-ready-to-arm")
    result = run(server, "follow", "walk", way)
    assert result.exit_code == 1
    assert "[drone-not-ready-to-arm]" in result.stderr
    assert server.last("POST", "/follows/f1/cancel")
