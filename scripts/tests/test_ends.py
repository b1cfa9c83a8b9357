"""A server that cannot do its duty ends, and is there again: by real faults, put into it from outside.

The drones of the demo fleet fly meanwhile; what they do is what they say themselves.
"""

import contextlib
import json
import os
import re
import signal
import socket
import struct
import subprocess
import threading
import time
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from .conftest import ROOT, Checkout
from .running import call_rest, descendants, get, pid_of
from .waiting import until

FAULTS = Path(__file__).parent / "faults" / "Faults.java"
BAD_SYSTEM = 66
UNIT = ROOT / "docker" / "dronemap.service"
STOPPED = [
    pytest.param("stop:lane-0", "lane-0", id="lane"),
    pytest.param("stop:operations", "operations", id="operations", marks=pytest.mark.soak),
    pytest.param("stop:conductor", "conductor", id="conductor", marks=pytest.mark.soak),
    pytest.param("stop:ledger", "ledger", id="ledger", marks=pytest.mark.soak),
    pytest.param("stop:journal", "journal", id="journal", marks=pytest.mark.soak),
    pytest.param("heap", "memory", id="heap", marks=pytest.mark.soak),
    pytest.param("direct", None, id="direct", marks=pytest.mark.soak),
    pytest.param("threads", None, id="threads", marks=pytest.mark.soak),
]


@pytest.fixture
def faults(built: Checkout, tmp_path: Path) -> Path:
    """The faults as a program and an agent, made with the JDK and the libraries of a server that runs."""
    assert built.run("up", "--no-demo").returncode == 0
    java = java_of(built)
    libraries = next((built.path / ".tools" / "app").glob("server-*/lib"))
    asm = next(libraries.glob("spring-core-*.jar"))
    made = tmp_path / "faults"
    made.mkdir()
    subprocess.run([java.with_name("javac"), "-nowarn", "-cp", asm, "-d", made, FAULTS], check=True)
    manifest = made / "manifest"
    manifest.write_text(
        f"Main-Class: Faults\nAgent-Class: Faults\nPremain-Class: Faults\nClass-Path: {asm.as_uri()}\n"
    )
    jar = made / "faults.jar"
    classes = [entry.name for entry in made.glob("*.class")]
    subprocess.run([java.with_name("jar"), "cfm", jar, manifest, *classes], cwd=made, check=True)
    return jar


def java_of(built: Checkout) -> Path:
    return Path(f"/proc/{pid_of(built, 'server')}/exe").readlink()


def inject_fault(built: Checkout, jar: Path, fault: str) -> None:
    subprocess.run([java_of(built), "-jar", jar, str(pid_of(built, "server")), fault], check=True, timeout=60)


def health(built: Checkout) -> dict[str, Any]:
    with contextlib.suppress(OSError, ValueError):
        answer: dict[str, Any] = json.loads(get(f"http://127.0.0.1:{built.http_port}/api/v1/health")[1])
        return answer
    return {}


def is_up_again(built: Checkout, before: int) -> bool:
    return pid_of(built, "server") != before and health(built).get("status") in ("up", "degraded")


def seconds_until_up_again(built: Checkout, before: int, since: float) -> float:
    until("the server is there again", lambda: is_up_again(built, before), 120)
    return time.monotonic() - since


@pytest.mark.parametrize(("fault", "part"), STOPPED)
def test_server_restarts_after_fatal_fault(
    built: Checkout, faults: Path, fault: str, part: str | None
) -> None:
    before = pid_of(built, "server")
    begun = time.monotonic()
    inject_fault(built, faults, fault)
    # There may be very many threads to be used up first.
    until("the process has ended", lambda: pid_of(built, "server") != before or not is_alive(before), 180)
    ended = time.monotonic()
    back = seconds_until_up_again(built, before, ended)
    print(
        f"{fault}: {time_used_up(built)}ended after {ended - begun:.1f} s, serving again after {back:.1f} s"
    )
    end = health(built)["lastEnd"]
    if part is not None:
        assert end["part"] == part
    parts = json.loads(call_rest(built, "/health/parts"))["ends"]
    assert [one["part"] for one in parts] == [end["part"]]
    assert parts[0]["why"].endswith(".")


def time_used_up(built: Checkout) -> str:
    """Text of when the resource was used up; empty for a fault that stops a thread."""
    log = (built.data / "logs" / "server.log").read_text(errors="replace")
    found = re.findall(r"used up after \d+ ms", log)
    return f"{found[-1]}, " if found else ""


def is_alive(pid: int) -> bool:
    with contextlib.suppress(OSError):
        return "Z" not in Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    return False


class Peer:
    """Heartbeats of a vehicle, from one address."""

    def __init__(self, built: Checkout, system: int) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(("127.0.0.1", int(built.settings["DRONEMAP_MAVLINK_UDP"])))
        self.port: int = self._socket.getsockname()[1]
        self._system = system
        self._sequence = 0

    def send_heartbeat(self) -> None:
        # A reset port of a server that is down refuses the datagram before.
        with contextlib.suppress(ConnectionRefusedError):
            self._socket.send(heartbeat(self._system, self._sequence))
        self._sequence = (self._sequence + 1) % 256


def heartbeat(system: int, sequence: int) -> bytes:
    """MAVLink 2, message 0: a copter with ArduPilot (https://mavlink.io/en/guide/serialization.html)."""
    payload = struct.pack("<IBBBBB", 0, 2, 3, 81, 3, 3)
    head = struct.pack("<BBBBBB", len(payload), 0, 0, sequence, system, 1) + b"\0\0\0"
    return b"\xfd" + head + payload + struct.pack("<H", crc(head + payload + bytes([50])))


def crc(data: bytes) -> int:
    """CRC-16/MCRF4XX."""
    value = 0xFFFF
    for byte in data:
        low = byte ^ (value & 0xFF)
        low ^= (low << 4) & 0xFF
        value = (value >> 8) ^ (low << 8) ^ (low << 3) ^ (low >> 4)
    return value


@contextlib.contextmanager
def sending_heartbeats(*peers: Peer) -> Iterator[None]:
    """Five times a second, as long as this lasts."""
    over = threading.Event()

    def send_heartbeat() -> None:
        while not over.wait(0.2):
            for peer in peers:
                peer.send_heartbeat()

    thread = threading.Thread(target=send_heartbeat, daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


def live_systems(built: Checkout) -> set[int]:
    drones = json.loads(call_rest(built, "/drones"))["drones"]
    return {drone["link"]["systemId"] for drone in drones if drone["link"]["state"] == "live"}


def test_peer_whose_frames_end_the_server_is_blocked(built: Checkout, faults: Path) -> None:
    assert built.run("down").returncode == 0
    options = f"{built.settings['DRONEMAP_JAVA_OPTS']} -javaagent:{faults}=frame"
    assert built.run("up", "--no-demo", DRONEMAP_JAVA_OPTS=options).returncode == 0
    good, bad = Peer(built, 7), Peer(built, BAD_SYSTEM)
    with sending_heartbeats(good, bad):
        until("it starts without what ended it", lambda: health(built).get("refusedPeers") == 1, 240)
        until("others are heard", lambda: live_systems(built) == {7})
    answer = health(built)
    assert answer["setAside"] is True
    parts = json.loads(call_rest(built, "/health/parts"))
    assert parts["refused"] == [f"127.0.0.1:{bad.port}"]
    assert len(parts["ends"]) == 3


@pytest.mark.soak
def test_operations_that_end_the_server_are_set_aside_and_drones_return(
    built: Checkout, faults: Path
) -> None:
    assert built.run("up").returncode == 0
    drone = next(one for one in json.loads(call_rest(built, "/drones"))["drones"] if one["readyToArm"])
    home = drone["home"]
    order = {
        "latitude": home["latitude"] + 0.0004,
        "longitude": home["longitude"],
        "drone": drone["id"],
        "place": {"side": "fixed", "bearing": 180, "distance": 15, "height": 20},
        "patience": 600,
    }
    follow = json.loads(call_rest(built, "/follows", order))["id"]
    order_follow(built, follow, order)
    call_rest(built, f"/follows/{follow}/start", {})

    def one() -> dict[str, Any]:
        return next(d for d in json.loads(call_rest(built, "/drones"))["drones"] if d["id"] == drone["id"])

    def follows() -> bool:
        order_follow(built, follow, order)
        return bool(json.loads(call_rest(built, f"/follows/{follow}"))["state"] == "tracking")

    until("it follows", follows)
    # The demo fleet flies on while the server is replaced by one that fails at every stored state.
    os.kill(pid_of(built, "supervisor"), signal.SIGTERM)
    until("it is stopped", lambda: not is_alive(pid_of(built, "server")))
    options = f"{built.settings['DRONEMAP_JAVA_OPTS']} -javaagent:{faults}=journal"
    # Its operations wait for their drones: it serves, and says that not all is well.
    again = built.run("up", DRONEMAP_JAVA_OPTS=options)
    assert again.returncode == 0, again.stderr
    until("it starts without operations", lambda: health(built).get("setAside") is True, 240)
    until("the drone goes home", lambda: one()["mode"] == "RTL")
    until("the drone is down", lambda: one()["armed"] is False)


def order_follow(built: Checkout, follow: str, order: dict[str, Any]) -> None:
    at = datetime.now(UTC).isoformat()
    here = {"at": at, "latitude": order["latitude"], "longitude": order["longitude"], "accuracy": 4}
    call_rest(built, f"/follows/{follow}/positions", {"sent": at, "positions": [here]})


@contextlib.contextmanager
def foreground_server(built: Checkout, *words: str, **settings: str) -> Iterator[subprocess.Popen[bytes]]:
    process = subprocess.Popen(words, env=built.environment(**settings), stdout=subprocess.DEVNULL)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(60)


def container_entry_point(built: Checkout) -> list[str]:
    lines = (ROOT / "docker" / "Dockerfile").read_text().splitlines()
    words = [json.loads(line.split(" ", 1)[1]) for line in lines if line.startswith(("ENTRYPOINT", "CMD"))]
    return [str(built.path / "dronemap"), *words[0][1:], *words[1], "--no-demo"]


def unit_setting(name: str) -> str:
    return str(re.findall(rf"^{name}=(.*)$", UNIT.read_text(), re.MULTILINE)[0])


@pytest.mark.soak
def test_container_restarts_server(built: Checkout, faults: Path) -> None:
    assert built.run("down").returncode == 0
    with foreground_server(built, *container_entry_point(built), container="docker"):
        until("it serves", lambda: health(built).get("status") == "up")
        before = pid_of(built, "server")
        inject_fault(built, faults, "stop:lane-0")
        until("the process has ended", lambda: not is_alive(before))
        print(
            f"container: serving again after {seconds_until_up_again(built, before, time.monotonic()):.1f} s"
        )
    assert descendants(built.data) == set()


@pytest.mark.soak
def test_service_restarts_server_and_ends_with_its_supervisor(built: Checkout, faults: Path) -> None:
    assert built.run("down").returncode == 0
    start = unit_setting("ExecStart").replace("/opt/dronemap", str(built.path)).split()
    with foreground_server(built, *start) as service:
        until("it serves", lambda: health(built).get("status") == "up")
        before = pid_of(built, "server")
        inject_fault(built, faults, "stop:lane-0")
        until("the process has ended", lambda: not is_alive(before))
        back = seconds_until_up_again(built, before, time.monotonic())
        print(f"service: serving again after {back:.1f} s")
        # Nobody but systemd is left then: the main process ends, and the unit has it started again.
        os.kill(pid_of(built, "supervisor"), signal.SIGKILL)
        assert service.wait(60) != 0
    assert unit_setting("Restart") == "always"
    assert unit_setting("StartLimitIntervalSec") == "0"
    assert str(service.returncode) not in unit_setting("RestartPreventExitStatus").split()


def test_the_unit_is_valid(built: Checkout, tmp_path: Path) -> None:
    made = tmp_path / UNIT.name
    made.write_text(UNIT.read_text().replace("/opt/dronemap", str(built.path)))
    outcome = subprocess.run(
        ["systemd-analyze", "verify", "--man=no", made], text=True, capture_output=True, check=False
    )
    assert (outcome.returncode, outcome.stderr.strip()) == (0, "")
