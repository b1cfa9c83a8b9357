"""Where the server and its key come from, versions, and the completion by real shells."""

import json
import os
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest
from fake_server import FakeServer, drone, run

from dronectl.__main__ import main
from dronemap import __version__

ROOT = Path(__file__).parents[2]
KEY = "a-key-that-nobody-may-see"


@pytest.fixture
def alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A machine without anything configured."""
    for name in list(os.environ):
        if name.startswith("DRONEMAP_"):
            monkeypatch.delenv(name)
    monkeypatch.setenv("DRONEMAP_CONFIG", str(tmp_path / "config.toml"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def dronectl(capsys: pytest.CaptureFixture[str], *args: str) -> tuple[int, str, str]:
    """Without a server in memory: what is configured counts."""
    code = 0
    try:
        main(list(args))
    except SystemExit as e:
        code = int(e.code or 0)
    printed = capsys.readouterr()
    return code, printed.out, printed.err


def profiles(folder: Path, text: str, mode: int = 0o600) -> None:
    file = folder / "config.toml"
    file.write_text(text)
    file.chmod(mode)


def origins(printed: str) -> Mapping[str, str]:
    return {name: found["from"] for name, found in json.loads(printed).items()}


def test_without_a_key_nothing_is_asked(alone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for args in (["config"], ["drones"]):
        code, _, err = dronectl(capsys, *args)
        assert code == 4
        assert "DRONEMAP_KEY" in err
        assert len(err.splitlines()) == 1


def test_config_tells_of_the_environment(
    alone: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DRONEMAP_URL", "https://drones.example")
    monkeypatch.setenv("DRONEMAP_KEY", KEY)
    code, out, err = dronectl(capsys, "config", "--json")
    assert (code, origins(out)["url"], origins(out)["key"]) == (0, "DRONEMAP_URL", "DRONEMAP_KEY")
    for args in (["config"], ["config", "--json"]):
        assert KEY not in "".join(dronectl(capsys, *args)[1:])


def test_config_tells_of_options_and_profiles(alone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    profiles(alone, f'[field]\nurl = "https://drones.example"\nkey = "{KEY}"\n')
    _, out, _ = dronectl(capsys, "--profile", "field", "config", "--json")
    assert json.loads(out)["url"]["value"] == "https://drones.example"
    assert origins(out)["url"] == origins(out)["key"] == f"profile field in {alone / 'config.toml'}"
    (alone / "key").write_text(KEY)
    (alone / "key").chmod(0o600)
    _, out, _ = dronectl(capsys, "config", "--json", "--url", "https://other.example", "--key-file", "key")
    assert (origins(out)["url"], origins(out)["key"]) == ("--url", "--key-file key")


def test_config_tells_of_the_key_of_this_machine(alone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (alone / ".data").mkdir()
    (alone / ".data" / "local-key").write_text(KEY)
    _, out, _ = dronectl(capsys, "config", "--json")
    assert (origins(out)["url"], origins(out)["key"]) == ("this machine", ".data/local-key of the checkout")


@pytest.mark.parametrize(("text", "mode", "why"), [(KEY, 0o644, "chmod 600"), ("", 0o600, "it is empty")])
def test_key_file_that_is_not_used(
    alone: Path, capsys: pytest.CaptureFixture[str], text: str, mode: int, why: str
) -> None:
    (alone / "key").write_text(text)
    (alone / "key").chmod(mode)
    code, _, err = dronectl(capsys, "drones", "--key-file", "key")
    assert (code, why in err) == (4, True)
    assert dronectl(capsys, "drones", "--key-file", "none")[0] == 4


def test_version_of_both() -> None:
    server = FakeServer()
    assert run(server, "version").stdout == f"dronectl {__version__}\nserver 0.9\n"
    assert json.loads(run(server, "version", "--json").stdout) == {"client": __version__, "server": "0.9"}
    server.away = True
    away = run(server, "version", "--timeout", "0.1")
    assert (away.exit_code, away.stdout) == (4, f"dronectl {__version__}\n")


def test_without_a_command_it_explains_itself(capsys: pytest.CaptureFixture[str]) -> None:
    for args in ([], ["mission"]):
        code, out, err = dronectl(capsys, *args)
        assert (code, out) == (2, "")
        assert err.startswith("Usage: dronectl")
    assert dronectl(capsys, "--version") == (0, f"dronectl {__version__}\n", "")


class _Answers(BaseHTTPRequestHandler):
    drones = (drone(), drone("d2", "Heron-2"), drone("d3", "Grey heron"))

    def do_GET(self) -> None:
        body = json.dumps({"drones": self.drones}).encode()
        self.send_response(200 if self.headers["Authorization"] == f"Bearer {KEY}" else 401)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *args: object) -> None:
        return None


@pytest.fixture
def shell(alone: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A machine on which dronectl is installed and a server runs."""
    server = HTTPServer(("127.0.0.1", 0), _Answers)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    installed = alone / "bin" / "dronectl"
    installed.parent.mkdir()
    installed.write_text(f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m dronectl "$@"\n')
    installed.chmod(0o700)
    monkeypatch.setenv("PATH", f"{installed.parent}:{os.environ['PATH']}")
    monkeypatch.setenv("DRONEMAP_URL", f"http://127.0.0.1:{server.server_port}")
    monkeypatch.setenv("DRONEMAP_KEY", KEY)
    yield alone
    server.shutdown()
    thread.join()
    server.server_close()


def script(program: str, text: str) -> str:
    """What the shell prints; a machine without it proves nothing about it."""
    if shutil.which(program) is None:
        pytest.skip(f"not proved: {program} is not installed")
    done = subprocess.run([program, "-c", text], capture_output=True, text=True, timeout=60)
    assert done.stderr == ""
    return done.stdout


def bash(*words: str) -> set[str]:
    line = " ".join(f"'{word}'" for word in words)
    text = f"""
        eval "$(dronectl completion bash)"
        COMP_WORDS=({line}) COMP_CWORD={len(words) - 1}
        _dronectl_completion dronectl
        printf '%s\\n' "${{COMPREPLY[@]}}"
    """
    return set(script("bash", text).split("\n")) - {""}


@pytest.mark.usefixtures("shell")
def test_bash_completes_commands_options_and_drones() -> None:
    assert bash("dronectl", "ta") == {"takeoff"}
    assert bash("dronectl", "mission", "cl") == {"clear"}
    assert bash("dronectl", "takeoff", "--no") == {"--no-wait"}
    # A name that is no single word stands there by its id.
    assert bash("dronectl", "takeoff", "10", "--drone", "") == {"Heron-1", "Heron-2", "d3"}
    assert bash("dronectl", "watch", "Heron-2", "Heron-1") == {"Heron-1"}
    assert bash("dronectl", "call", "listDro") == {"listDrones", "listDroneEvents", "listDroneTelemetryPoints"}


@pytest.mark.usefixtures("shell")
def test_completion_is_silent_when_the_server_does_not_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DRONEMAP_KEY", "another")
    assert bash("dronectl", "takeoff", "10", "--drone", "") == set()
    monkeypatch.setenv("DRONEMAP_URL", "http://127.0.0.1:1")
    assert bash("dronectl", "takeoff", "10", "--drone", "") == set()
    monkeypatch.delenv("DRONEMAP_KEY")
    assert bash("dronectl", "takeoff", "10", "--drone", "") == set()


@pytest.mark.usefixtures("shell")
def test_zsh_completes_drones() -> None:
    text = """
        compdef() { : }
        _describe() { print -l -- ${(P)3} }
        compadd() { print -l -- ${(P)argv[-1]} }
        eval "$(dronectl completion zsh)"
        words=(dronectl takeoff 10 --drone Heron) CURRENT=5
        _dronectl_completion
    """
    assert {"Heron-1", "Heron-2"} <= {line.split(":")[0] for line in script("zsh", text).split("\n")}


@pytest.mark.usefixtures("shell")
def test_fish_completes_drones(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    printed = script("fish", "dronectl completion fish | source; complete -C 'dronectl takeoff 10 --drone Heron'")
    assert {line.split("\t")[0] for line in printed.splitlines()} == {"Heron-1", "Heron-2"}
