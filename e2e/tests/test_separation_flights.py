"""Operations of several users through each other's ways, by true states; also when the server is killed."""

import os
import random
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.api import Api
from dronemap_e2e.operations_together import (
    RunOperation,
    VirtualOperation,
    ready,
    scattered,
    supervisor,
)
from dronemap_e2e.separation_judge import write_rows
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.sitl_drone import Column, SitlDrone, sitl_drones
from dronemap_e2e.true_tracks import Flight, TrueTracks, true_fixes
from dronemap_e2e.waiting import wait_for

pytestmark = pytest.mark.soak
SEEDS = os.environ.get("DRONEMAP_TRIAL_SEEDS", "1-1")
TABLE = ROOT / "docs" / "trials" / "separation-flights.tsv"
FIRST = 21
LONGEST_SECONDS = 420
# The last ones of them set off about then.
KILLED_FROM, KILLED_UNTIL = 12.0, 110.0
# As long as a machine takes to start a process again.
AWAY_SECONDS = 15.0


def seeds() -> range:
    first, _, last = SEEDS.partition("-")
    return range(int(first), int(last or first) + 1)


@pytest.fixture
def simulator(own_server: Server, tmp_path: Path) -> Iterator[Simulator]:
    started = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{own_server.udp_port}",
        *("--count", "8", "--sysid", str(FIRST)),
    )
    yield started
    started.stop()


@pytest.fixture
def tracks(simulator: Simulator) -> Iterator[TrueTracks]:
    opened = TrueTracks(simulator)
    yield opened
    opened.close()


def operations(server: Server, scenario: str, seed: int) -> list[RunOperation | VirtualOperation]:
    """Two runs, and with more of them two virtual drones."""
    local = Api(server.address, server.local_key())
    drones = ready(local, [FIRST + number for number in range(8)])
    chance = random.Random(seed)
    home = drones[3]["home"]
    parts: list[RunOperation | VirtualOperation] = []
    if scenario != "virtual-drone":
        first, second = drones[0:2], drones[4:6]
        if scenario == "killed":
            first, second = drones[0:3], drones[4:7]
        for name, own in (("run 1", first), ("run 2", second)):
            parts.append(RunOperation(name, supervisor(server, local), own, scattered(home, 4, chance)))
    else:
        parts.append(
            RunOperation("run 1", supervisor(server, local), drones[0:3], scattered(home, 5, chance))
        )
    if scenario != "two-runs":
        for drone in (drones[3], drones[7]):
            assert local.call("PUT", f"/warehouse/{drone['id']}").ok
        for number in (1, 2):
            user = supervisor(server, local)
            parts.append(
                VirtualOperation(
                    f"virtual {number}", user, drones[3 if number == 1 else 7], scattered(home, 3, chance)
                )
            )
    return parts


@pytest.mark.parametrize("seed", seeds())
@pytest.mark.parametrize("scenario", ["two-runs", "virtual-drone"])
def test_operations_keep_apart_over_real_sockets(
    scenario: str, seed: int, own_server: Server, tracks: TrueTracks, tmp_path: Path
) -> None:
    parts = operations(own_server, scenario, seed)
    for part in parts:
        part.begin()
    wait_for("somebody flies", lambda: tracks.down_for() == 0, 90)
    wait_for("all are down", lambda: _is_over(own_server) and tracks.down_for() > 1, LONGEST_SECONDS)
    tracks.close()

    flight = Flight(f"{scenario}-over-sockets", seed, [part.operation for part in parts])
    verdict = flight.judged(tmp_path / "judged", tracks.fixes())
    write_rows(TABLE, [verdict])
    assert verdict.result == "ok", verdict.words


def _is_over(server: Server) -> bool:
    api = Api(server.address, server.local_key())
    runs = all(run["state"] == "over" for run in api.get("/runs")["runs"])
    virtual = all(
        one["run"] is None or one["run"]["state"] in ("done", "failed")
        for one in api.get("/virtual-drones")["virtualDrones"]
    )
    return runs and virtual


@pytest.mark.parametrize("seed", seeds())
def test_killed_server_leaves_drones_apart(
    seed: int, own_server: Server, tracks: TrueTracks, tmp_path: Path
) -> None:
    parts = operations(own_server, "killed", seed)
    chance = random.Random(1_000 + seed)
    for part in parts:
        part.begin()
    wait_for("somebody flies", lambda: tracks.down_for() == 0, 90)
    moment = time.monotonic() + chance.uniform(KILLED_FROM, KILLED_UNTIL)
    wait_for("the moment has come", lambda: time.monotonic() >= moment, 2 * KILLED_UNTIL, every=0.05)
    own_server.kill()
    if seed % 2:
        wait_for("it was away", lambda: time.monotonic() > moment + AWAY_SECONDS, 2 * AWAY_SECONDS)
        own_server.start()
    # Also those that a server which is back may send up again.
    wait_for("all stay down", lambda: tracks.down_for() > 25, LONGEST_SECONDS)
    tracks.close()

    flight = Flight("killed-over-sockets", seed, [part.operation for part in parts])
    for part in parts:
        part.operation.required = False
        part.operation.undisturbed = None
    verdict = flight.judged(tmp_path / "judged", tracks.fixes(), moment)
    write_rows(TABLE, [verdict])
    assert verdict.result == "ok", verdict.words


def _armed(drone: SitlDrone) -> bool:
    return drone.autopilot.ground_truth.armed()


@pytest.mark.skipif(sitl.COPTER.binary is None, reason=sitl.COPTER.why_not)
def test_runs_of_two_users_keep_apart_with_real_autopilots(tmp_path: Path) -> None:
    columns = [Column("Copter", sitl.COPTER, 91 + number) for number in range(4)]
    with sitl_drones(tmp_path, columns, apart_metres=20) as drones:
        for drone in drones:
            drone.becomes_ready()
        api = drones[0].api
        states = ready(api, [column.system_id for column in columns])
        chance = random.Random(1)
        server = drones[0].server
        parts = [
            RunOperation(
                f"run {number + 1}",
                supervisor(server, api),
                [states[number], states[number + 2]],
                scattered(states[1]["home"], 4, chance),
            )
            for number in range(2)
        ]
        for part in parts:
            part.begin()
        wait_for("they are over", lambda: _is_over(server), LONGEST_SECONDS)
        wait_for("all motors are off", lambda: not any(_armed(drone) for drone in drones), 60)

        flight = Flight("two-runs-of-real-autopilots", 1, [part.operation for part in parts])
        fixes = {
            str(column.system_id): true_fixes(drone) for column, drone in zip(columns, drones, strict=True)
        }
        verdict = flight.judged(tmp_path / "judged", fixes)
        write_rows(TABLE, [verdict])
        assert verdict.result == "ok", verdict.words
