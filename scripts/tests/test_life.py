"""The life of a server under the one script: start, start again, crash, replay, stop.

The tests share one checkout, whose data lie where they lie when nobody says otherwise.
"""

import json
import os
import re
import shutil
import signal
import stat
import subprocess
import time
import urllib.error
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from .conftest import SOON, Checkout, on_free_ports
from .running import call_rest, descendants, get, listeners, pid_of
from .waiting import until

SECOND_UP_SECONDS = 30
MOST_MEGABYTES = 600


@pytest.fixture(scope="module")
def built(with_jars: Path) -> Iterator[Checkout]:
    made = on_free_ports(with_jars, DRONEMAP_JAVA_OPTS=SOON)
    yield made
    made.run("down")
    shutil.rmtree(made.data, ignore_errors=True)


def test_up_starts_page_and_demo_drone_that_arms(built: Checkout, monkeypatch: pytest.MonkeyPatch) -> None:
    # As it is without any setting: its memory is measured.
    monkeypatch.delitem(built.settings, "DRONEMAP_JAVA_OPTS")
    assert not built.data.exists()
    outcome = built.run("up")
    assert outcome.returncode == 0, outcome.stderr
    address = f"http://127.0.0.1:{built.http_port}"
    assert f"Dronemap is ready: {address}" in outcome.stdout
    assert "one-time password" in outcome.stdout
    assert "<html" in get(address)[1].lower()
    health = health_when_all_live(built)
    assert health["status"] == "up"
    assert health["drones"]["ready"] >= 1
    check_demo_drone_arms(built)
    assert resident_megabytes(pid_of(built, "server")) < MOST_MEGABYTES

    check_secrets(built.data)
    own = descendants(built.data)
    assert {pid_of(built, "server"), pid_of(built, "sim")} <= own
    addresses = listeners(own)
    assert any(address.endswith(f":{built.http_port}") for address in addresses)
    off_loopback = [a for a in addresses if not re.match(r"(127\.|\[::1\]|\[::ffff:127\.)", a)]
    assert off_loopback == []

    server = pid_of(built, "server")
    assert built.run("up").returncode == 0
    assert pid_of(built, "server") == server, "a second up must leave the running server alone"

    status = built.run("status")
    assert status.returncode == 0
    assert address in status.stdout
    assert built.run("logs").returncode == 0
    # The first one has disarmed itself by now, or has not.
    check_demo_drone_arms(built)
    down = built.run("down")
    assert down.returncode == 0
    assert re.search(r"Armed when last heard: [12]\.", down.stderr)
    assert descendants(built.data) == set()
    assert built.run("status").returncode == 1


def health_when_all_live(built: Checkout) -> dict[str, Any]:
    """Health once no drone is silent: on a busy machine the simulator may be so for a moment."""
    seen: dict[str, Any] = {}

    def all_live() -> bool:
        seen.update(json.loads(get(f"http://127.0.0.1:{built.http_port}/api/v1/health")[1]))
        drones = seen["drones"]
        return bool(drones["live"] > 0 and drones["suspect"] == drones["lost"] == 0)

    until("no drone is silent", all_live)
    return seen


def check_demo_drone_arms(built: Checkout) -> None:
    """At once, for that is what "ready" promises: by the drone's own word and by its deed."""
    health_when_all_live(built)
    drones = json.loads(call_rest(built, "/drones"))["drones"]
    may = [drone for drone in drones if drone["readyToArm"] and drone["actions"]["arm"]["allowed"]]
    assert may, [(drone["name"], drone["readyToArm"], drone["messages"]) for drone in drones]
    command = json.loads(call_rest(built, f"/drones/{may[0]['id']}/commands?wait=20", {"type": "arm"}))
    assert command["outcome"]["result"] == "succeeded", command


def resident_megabytes(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text()
    return int(re.findall(r"VmRSS:\s+(\d+)", status)[0]) / 1024


def check_secrets(data: Path) -> None:
    for name in ("first-password.txt", "local-key"):
        mode = stat.S_IMODE((data / name).stat().st_mode)
        assert mode == 0o600, f"{name} has mode {mode:o}"
    assert stat.S_IMODE(data.stat().st_mode) & 0o077 == 0


def test_start_after_kill(built: Checkout) -> None:
    assert built.run("up").returncode == 0
    os.kill(pid_of(built, "server"), signal.SIGKILL)
    again = built.run("up")
    assert again.returncode == 0, again.stderr


@pytest.mark.soak
def test_php_page_is_started_and_stopped(built: Checkout) -> None:
    address = f"http://127.0.0.1:{built.settings['DRONEMAP_PHP_PORT']}/"
    outcome = built.run("up", "--php")
    assert outcome.returncode == 0, outcome.stderr
    assert f"PHP page: {address}" in outcome.stdout
    assert "<html" in get(address)[1].lower()
    with pytest.raises(urllib.error.HTTPError, match="401"):
        get(address + "proxy.php?operation=arm")
    assert address in built.run("status").stdout
    php = pid_of(built, "php")
    assert php in descendants(built.data)
    server = pid_of(built, "server")
    assert built.run("up", "--php").returncode == 0
    assert (pid_of(built, "php"), pid_of(built, "server")) == (php, server)
    without = built.run("up")
    assert without.returncode == 0
    assert "Stopping the PHP page" in without.stdout
    assert pid_of(built, "server") == server
    assert built.run("up", "--php").returncode == 0
    assert built.run("down").returncode == 0
    assert descendants(built.data) == set()
    refused = built.run("up", "--php", "--public")
    assert refused.returncode == 2
    assert "--php is for this machine alone" in refused.stderr


def test_up_takes_less_than_half_a_minute(built: Checkout) -> None:
    """On a machine with nothing else to do."""
    assert built.run("up").returncode == 0
    assert seconds_of_up(built) < SECOND_UP_SECONDS
    os.kill(pid_of(built, "server"), signal.SIGKILL)
    assert seconds_of_up(built) < SECOND_UP_SECONDS


def seconds_of_up(built: Checkout) -> float:
    begun = time.monotonic()
    assert built.run("up").returncode == 0
    return time.monotonic() - begun


@pytest.mark.skipif("DRONEMAP_TEST_DATA" not in os.environ, reason="DRONEMAP_TEST_DATA is not set")
def test_replays_a_recording_and_cancels_it_on_interruption(built: Checkout) -> None:
    recordings = sorted(
        Path(os.environ["DRONEMAP_TEST_DATA"]).glob("tlogs/*.tlog"), key=lambda f: f.stat().st_size
    )
    assert built.run("up").returncode == 0
    finished = built.run("replay", str(recordings[0]), "--speed", "100")
    assert finished.returncode == 0, finished.stderr
    assert "good messages" in finished.stdout

    replay = subprocess.Popen(
        [built.path / "dronemap", "replay", recordings[-1], "--speed", "1"],
        env=built.environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert replay.stdout is not None
    while "drones:" not in replay.stdout.readline():
        assert replay.poll() is None
    replay.send_signal(signal.SIGINT)
    replay.communicate(timeout=20)
    assert replay.returncode == 130
    states = [replay["state"] for replay in json.loads(call_rest(built, "/replays"))["replays"]]
    assert sorted(states) == ["cancelled", "finished"]


def test_down_cleans_up_killed_server(built: Checkout) -> None:
    assert built.run("up").returncode == 0
    os.kill(pid_of(built, "server"), signal.SIGKILL)
    assert built.run("down").returncode == 0
    assert descendants(built.data) == set()
