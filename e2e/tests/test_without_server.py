"""Vehicles after a kill of the server in flight, for good or until it is started again."""

import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.api import Api, Json
from dronemap_e2e.datagram_recorder import DatagramRecorder
from dronemap_e2e.separation import fixes, nearest
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.sitl import Autopilot, arms_and_enters_guided
from dronemap_e2e.waiting import wait_for
from dronemap_e2e.walker import beside

FIRST = 31
RTL = 6
HEIGHT = 20
# Beside each other, far out: the first of them where the last one's home is, so that their ways home cross.
ROW_NORTH, ROW_SPACING = 160.0, 14.0
SIMULATED, REAL = 10, 4
# docs/times.md
VEHICLE_RETURNS, STARTED_AGAIN = 20.0, 15.0
# What a second of heartbeats, and their way, may make of it.
SLACK = 2.5
SHARE = 0.9
NEAR = 3.0
STARTS = 5
LATITUDE, LONGITUDE, HOME_AMSL = 47.3977, 8.5456, 488.0
HOMES_APART = 20.0


@contextmanager
def recording(server: Server) -> Iterator[DatagramRecorder]:
    recorder = DatagramRecorder(server.udp_port)
    try:
        yield recorder
    finally:
        recorder.close()


@contextmanager
def simulated(count: int, port: int, folder: Path) -> Iterator[Simulator]:
    simulator = Simulator(
        folder / "sim.log",
        f"udp://127.0.0.1:{port}",
        *("--count", str(count), "--sysid", str(FIRST)),
        *("--parameter", "FS_GCS_ENABLE=0", "--parameter", "FS_GCS_TIMEOUT=5"),
        *("--parameter", "RTL_LOIT_TIME=0", "--parameter", "LAND_SPEED=150"),
    )
    try:
        yield simulator
    finally:
        simulator.stop()


def ready(api: Api, count: int, seconds: float = 120) -> list[Json]:
    return [
        wait_for(f"{one} is ready", partial(api.ready, one), seconds) for one in range(FIRST, FIRST + count)
    ]


def fly_in_a_row(api: Api, drones: list[Json]) -> None:
    """All at once in the air, under guided control by plain commands."""
    middle = drones[len(drones) // 2]["home"]

    def goes(number: int) -> None:
        drone = drones[number]["id"]
        api.do(drone, type="setMode", mode="GUIDED")
        api.do(drone, type="arm")
        api.do(drone, type="takeOff", altitude=HEIGHT)
        wait_for(
            "it is high", lambda: api.drone(drone)["position"]["altitudeAboveHome"] > HEIGHT - 1, 90, 0.5
        )
        place = beside(middle, (len(drones) - 1 - number) * ROW_SPACING, ROW_NORTH)
        there = {"latitude": place.latitude, "longitude": place.longitude, "altitude": HEIGHT}
        api.do(drone, type="goTo", altitudeReference="home", **there)

        def is_there() -> bool:
            position = api.drone(drone)["position"]
            return place.metres_to(position["latitude"], position["longitude"]) < NEAR

        wait_for("it is there", is_there, 90, 0.5)

    with ThreadPoolExecutor(len(drones)) as pool:
        list(pool.map(goes, range(len(drones))))


def check_all_return(recorder: DatagramRecorder, count: int, killed: float) -> None:
    """Judged by what was on the wire alone."""
    vehicles = range(FIRST, FIRST + count)

    def down() -> bool:
        return all(not recorder.of(one).states[-1].armed for one in vehicles)

    wait_for("all are down", down, 400, every=2)
    until = time.monotonic()
    logs = {one: recorder.of(one) for one in vehicles}
    after = {}
    for one, log in logs.items():
        states = log.since(killed)
        assert states[0].height > HEIGHT - 3, f"{one} was not in the air: {states[0]}"
        last = max(timed.at for timed in log.sent_since(0, "HEARTBEAT"))
        after[one] = next(state.at for state in states if state.mode == RTL) - last
    apart = nearest({one: fixes(log, killed) for one, log in logs.items()}, killed, until)
    tops = {one: max(fix.height for fix in fixes(log, killed)) for one, log in logs.items()}
    print(f"home after {min(after.values()):.1f} to {max(after.values()):.1f} s")
    print(f"nearest {apart.share:.2f} ({apart.words}); at {sorted(round(top) for top in tops.values())} m")
    assert max(after.values()) < VEHICLE_RETURNS + SLACK
    assert min(after.values()) > VEHICLE_RETURNS - SLACK
    assert apart.share > SHARE, apart.words


@pytest.mark.soak
def test_ten_copters_return_home_without_server(own_server: Server, tmp_path: Path) -> None:
    """End to end because a process is killed, and what its vehicles do then is seen on the wire alone."""
    with recording(own_server) as recorder, simulated(SIMULATED, recorder.port, tmp_path):
        api = Api(own_server.address, own_server.local_key())
        fly_in_a_row(api, ready(api, SIMULATED))
        own_server.kill()
        check_all_return(recorder, SIMULATED, time.monotonic())


@pytest.mark.soak
@pytest.mark.skipif(sitl.COPTER.binary is None, reason=sitl.COPTER.why_not)
def test_four_real_autopilots_return_home_without_server(own_server: Server, tmp_path: Path) -> None:
    """End to end because it is the firmware that decides to come home."""
    with ExitStack() as all_of_it:
        recorder = all_of_it.enter_context(recording(own_server))
        for number in range(REAL):
            place = beside({"latitude": LATITUDE, "longitude": LONGITUDE}, number * HOMES_APART, 0)
            home = f"{place.latitude:.7f},{place.longitude:.7f},{HOME_AMSL},0"
            copter = Autopilot(
                sitl.COPTER, tmp_path / f"copter-{number}", recorder.port, FIRST + number, home
            )
            all_of_it.callback(copter.close)
        api = Api(own_server.address, own_server.local_key())
        drones = ready(api, REAL, 180)
        for drone in drones:
            wait_for(
                f"{drone['name']} may fly", partial(arms_and_enters_guided, api, drone["id"]), 120, every=3
            )
        fly_in_a_row(api, drones)
        own_server.kill()
        check_all_return(recorder, REAL, time.monotonic())


@pytest.mark.soak
def test_restarted_server_sends_heartbeats_before_vehicles_return(own_server: Server, tmp_path: Path) -> None:
    """End to end because a process is killed and started."""
    delays = []
    with recording(own_server) as recorder, simulated(SIMULATED, recorder.port, tmp_path):
        ready(Api(own_server.address, own_server.local_key()), SIMULATED)
        for _ in range(STARTS):
            own_server.kill()
            killed = time.monotonic()
            own_server.start()

            def received_by_all(since: float = killed) -> list[float] | None:
                heartbeats = [
                    recorder.of(one).sent_since(since + 0.2, "HEARTBEAT")
                    for one in range(FIRST, FIRST + SIMULATED)
                ]
                return [one[0].at - since for one in heartbeats] if all(heartbeats) else None

            delays.append(max(wait_for("all hear it again", received_by_all, 60)))
    print(f"all heard it again after {', '.join(f'{one:.1f}' for one in delays)} s")
    assert max(delays) < STARTED_AGAIN
