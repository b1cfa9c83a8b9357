"""A flight while the database is away: counted telemetry is the most that is lost."""

import os
import signal
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import pytest
import zeep.exceptions

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import flight_of, seconds_of, triangle
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS


@dataclass
class FlyingCopter:
    """A copter in the air, and the flight that is remembered of it."""

    server: Server
    api: Api
    drone: str
    flight: Json


@pytest.fixture
def flying_copter(killable_server: Server, tmp_path: Path) -> Iterator[FlyingCopter]:
    system_id = next(SYSTEM_IDS)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{killable_server.udp_port}",
        *("--count", "1", "--sysid", str(system_id)),
        *QUICK_FLIGHT,
    )
    try:
        api = Api(killable_server.address, killable_server.local_key())
        drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)["id"]
        api.do(drone, type="arm")
        api.do(drone, type="takeOff", altitude=8)
        flight = wait_for("the flight is known", lambda: flight_of(api, drone, "running"), 30)
        wait_for("telemetry is kept", lambda: stored_until(api, drone), 60)
        yield FlyingCopter(killable_server, api, drone, flight)
    finally:
        simulator.stop()


def test_database_outage_loses_only_counted_telemetry(
    flying_copter: FlyingCopter,
) -> None:
    """End to end because the PostgreSQL that is killed here, and found again, is a real one."""
    api, drone = flying_copter.api, flying_copter.drone
    begin, dropped = time.time(), api.get("/history")["dropped"]
    far = triangle(api.drone(drone)["home"], side=30)[1]
    go_to = {"type": "goTo", "latitude": far.latitude, "longitude": far.longitude, "altitude": 12}
    service = soap(flying_copter.server, flying_copter.server.local_key(), "RecordService")
    before = api.command(drone, go_to)
    with database_away(flying_copter.server.data), ThreadPoolExecutor() as at_once:
        wait_for("it is said", lambda: api.get("/health")["history"] == "down", 10)
        flight = at_once.submit(api.call, "GET", f"/flights/{flying_copter.flight['id']}")
        flights = at_once.submit(service.listFlights, drone=drone)
        # Nothing is sent that is not written down first; and it is said at once.
        command = at_once.submit(
            Api(flying_copter.server.address, api.key).call, "POST", f"/drones/{drone}/commands", go_to
        )
        assert flight.result().status_code == 503, flight.result().text
        assert command.result().status_code == 503, command.result().text
        # But whoever flies can be stopped by those who were known before.
        stop = Api(flying_copter.server.address, api.key).call(
            "POST", f"/drones/{drone}/commands", {"type": "hold"}
        )
        assert stop.status_code in (200, 202), stop.text
        wait_for("it holds", lambda: api.drone(drone)["mode"] == "BRAKE", 20)
        fault = flights.exception()
        assert isinstance(fault, zeep.exceptions.Fault) and "cannot be reached" in str(fault), fault
        away_until = time.time()

    wait_for("it is well again", lambda: api.get("/health")["history"] == "up", 30)
    wait_for("what waited is written", lambda: (stored_until(api, drone) or 0) > away_until, 30)
    history = api.get("/history")
    times = [begin, *stored_times(api, drone, begin)]
    longest = max(after - before for before, after in zip(times, times[1:], strict=False))
    assert longest < 1 or history["dropped"] > dropped, (
        f"{longest:.1f} s are missing, and not counted: {history}"
    )
    assert api.command(drone, go_to)["outcome"]["result"] == "succeeded"
    wait_for(
        "the command from before is remembered", lambda: command_is_stored(flying_copter, before["id"]), 30
    )


@contextmanager
def database_away(data: Path) -> Iterator[None]:
    """The server's own database is killed, and cannot be started again."""
    (program,) = (path for path in data.rglob("bin/postgres") if path.is_file())
    hidden = program.with_name("postgres-away")
    program.rename(hidden)
    for process in processes_in(data):
        os.kill(process, signal.SIGKILL)
    try:
        yield
    finally:
        hidden.rename(program)


def processes_in(data: Path) -> list[int]:
    """The database's: they alone work in a folder below the server's data."""
    found = []
    for process in Path("/proc").iterdir():
        try:
            inside = process.name.isdigit() and (process / "cwd").readlink().is_relative_to(data)
        except OSError:
            continue
        if inside:
            found.append(int(process.name))
    return found


def command_is_stored(flying_copter: FlyingCopter, command: str) -> bool:
    events = flying_copter.api.get(f"/flights/{flying_copter.flight['id']}/events")["events"]
    return any(e["command"] == command and e["result"] == "succeeded" for e in events)


def stored_until(api: Api, drone: str) -> float | None:
    return max(stored_times(api, drone, time.time() - 30), default=None)


def stored_times(api: Api, drone: str, since: float) -> list[float]:
    begin = datetime.fromtimestamp(since, UTC).isoformat().replace("+00:00", "Z")
    return [seconds_of(p["at"]) for p in api.get(f"/drones/{drone}/telemetry/points?from={begin}")["points"]]
