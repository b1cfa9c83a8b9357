"""Runs of drones with nothing wrong with them, in gusts, over links that lose much: nobody is given up."""

import json
import os
import random
import time
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.big_trial import to_degrees
from dronemap_e2e.heartbeats import HeartbeatGaps
from dronemap_e2e.impairer import Impairer, LinkConditions
from dronemap_e2e.runs import create_plan, ready_drone, run_if_over, stages
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

# "1-17": so many rounds of twelve runs at the same time, each round by its seed.
SEEDS = os.environ.get("DRONEMAP_HEALTHY_SEEDS", "1")
RUNS = 12
DRONES = 3
WAYPOINTS = 9
# The simulator's field: as many rows as columns.
SIDE = 6
GUSTY_WIND = 6
LOSSY = LinkConditions(delay=0.03, jitter=0.02, loss=0.1)
# What a run says of a drone that it does not count on any more, or not for all that it was to do.
DOUBTS = {
    *("lost", "gone", "crashed", "lowBattery", "wentHome", "cameDown", "removed"),
    *("offPath", "late", "commandFailed", "givenUp", "takenOver"),
}


def seeds() -> range:
    first, _, last = SEEDS.partition("-")
    return range(int(first), int(last or first) + 1)


@dataclass
class Field:
    """Twelve threes of drones, each on a strip of its own."""

    seed: int
    folder: Path
    api: Api
    link: Impairer
    gaps: HeartbeatGaps

    def waypoints(self, drones: list[Json], chance: random.Random) -> list[Json]:
        home = drones[0]["home"]
        return [
            to_degrees(home, chance.uniform(-25, 145), chance.uniform(-22, 22))
            | {
                "altitude": home["altitudeAmsl"] + chance.choice([15, 20, 25]),
                "altitudeReference": "amsl",
            }
            for _ in range(WAYPOINTS)
        ]


@pytest.fixture
def field(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Field]:
    seed: int = request.param
    server = Server(tmp_path / "data")
    server.start()
    link = Impairer(server.udp_port, seed)
    gaps = HeartbeatGaps(seed)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--count", str(RUNS * DRONES), "--seed", str(seed), "--wind", str(GUSTY_WIND)),
    )
    yield Field(seed, tmp_path, Api(server.address, server.local_key()), link, gaps)
    simulator.stop()
    link.close()
    server.stop()


def sets_of_three() -> list[list[int]]:
    """System ids of neighbours in one row."""
    assert RUNS * DRONES == SIDE * SIDE and SIDE % DRONES == 0
    return [[1 + run * DRONES + n for n in range(DRONES)] for run in range(RUNS)]


@pytest.mark.soak
@pytest.mark.parametrize("field", seeds(), indirect=True, ids=str)
def test_no_drone_is_given_up_for_gusts_heartbeat_gaps_or_losses(field: Field) -> None:
    api, chance = field.api, random.Random(field.seed)
    drones = {
        system_id: wait_for("all is known", partial(ready_drone, api, system_id), 180)
        for three in sets_of_three()
        for system_id in three
    }
    field.link.conditions = LOSSY
    field.link.drops = field.gaps.drops
    runs = {}
    for three in sets_of_three():
        fleet = [drones[system_id] for system_id in three]
        plan = create_plan(api, fleet, field.waypoints(fleet, chance))
        asked = {"plan": plan, "onCloudLoss": chance.choice(["rtl", "continue"]), "searchSeconds": 1}
        started = api.call("POST", "/runs", asked)
        assert started.status_code == 201, started.text
        runs[f"/runs/{started.json()['id']}"] = (three, time.monotonic())

    wrong = []
    for run, (three, since) in runs.items():
        over = wait_for(f"{run} is over", partial(run_if_over, api, run), 600, every=1)
        gaps = [sum(at > since for at in field.gaps.gaps.get(system_id, [])) for system_id in three]
        (field.folder / f"run-{three[0]}.json").write_text(json.dumps(over, indent=1))
        assert all(gaps), f"no gap between heartbeats: {gaps}"
        doubts = [one["words"] for one in over["explanations"] if one["trigger"] in DOUBTS]
        if doubts or set(stages(over).values()) != {"landed"} or over["counts"]["visited"] != WAYPOINTS:
            wrong.append((run, stages(over), over["counts"], doubts))
    assert field.link.lost > field.link.forwarded / 20
    assert not wrong, "\n".join(map(str, wrong))
