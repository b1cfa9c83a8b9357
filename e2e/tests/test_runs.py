"""A mission run: what one drone leaves the others fly, over a crash of the server."""

import math
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import EARTH_RADIUS_METERS
from dronemap_e2e.message_recorder import MessageRecorder
from dronemap_e2e.runs import (
    create_plan,
    distance,
    ready_drone,
    run_if_over,
    stages,
    tracks,
    waypoints_in_state,
)
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

FIRST_SYSTEM_ID = 181
DRONES = 3
WAYPOINTS = 12
SPACING_METRES = 30
HEIGHT_METRES = 20
NEAR_METRES = 5.0


@pytest.fixture
def recorder(own_server: Server) -> Iterator[MessageRecorder]:
    opened = MessageRecorder(own_server.udp_port)
    yield opened
    opened.close()


@pytest.fixture
def simulator(recorder: MessageRecorder, tmp_path: Path) -> Iterator[Simulator]:
    started = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{recorder.port}",
        *("--count", str(DRONES), "--speedup", "5", "--sysid", str(FIRST_SYSTEM_ID)),
    )
    yield started
    started.stop()


def waypoints(home: Json) -> list[Json]:
    """Four by three, north of a home."""
    per_degree = math.radians(1) * EARTH_RADIUS_METERS
    east = per_degree * math.cos(math.radians(home["latitude"]))
    return [
        {
            "latitude": home["latitude"] + (1 + n % 4) * SPACING_METRES / per_degree,
            "longitude": home["longitude"] + (n // 4 - 1) * SPACING_METRES / east,
            "altitude": home["altitudeAmsl"] + HEIGHT_METRES,
            "altitudeReference": "amsl",
        }
        for n in range(WAYPOINTS)
    ]


@pytest.mark.soak
def test_run_replaces_crashed_drone_and_survives_server_crash(
    own_server: Server, recorder: MessageRecorder, simulator: Simulator
) -> None:
    api = Api(own_server.address, own_server.local_key())
    drones = [
        wait_for("all is known", partial(ready_drone, api, FIRST_SYSTEM_ID + n), 120) for n in range(DRONES)
    ]
    asked = {
        "plan": create_plan(api, drones, waypoints(drones[0]["home"])),
        "name": "roofs",
        "onCloudLoss": "continue",
    }
    started = api.call("POST", "/runs", asked)
    assert started.status_code == 201, started.text
    run = f"/runs/{started.json()['id']}"
    wait_for("all fly", lambda: set(stages(api.get(run)).values()) == {"flying"}, 120)

    fallen = drones[0]["id"]
    wait_for("it is on its way", lambda: waypoints_in_state(api.get(run), fallen, "visited"), 120)
    left = [one["id"] for one in waypoints_in_state(api.get(run), fallen, "assigned")]
    simulator.fault(f"{FIRST_SYSTEM_ID} motor-failure")
    wait_for("it is given up", lambda: stages(api.get(run))[fallen] == "crashed", 30)

    own_server.kill()
    own_server.start()
    again = Api(own_server.address, own_server.local_key())
    over = wait_for("it is over", partial(run_if_over, again, run), 240)

    assert over["counts"]["visited"] == WAYPOINTS, over["explanations"]
    flown = tracks(recorder, drones, FIRST_SYSTEM_ID)
    for one in over["waypoints"]:
        off = distance(one, flown[one["visits"][0]["drone"]])
        assert off < NEAR_METRES, (one, off)
    by_others = {one["id"] for one in over["waypoints"] if one["visits"][0]["drone"] != fallen}
    assert left and set(left) & by_others, (left, over)
    triggers = [one["trigger"] for one in over["explanations"]]
    assert "crashed" in triggers and "restarted" in triggers, triggers
    replay = again.get(f"{run}/journal/replay")
    assert replay["same"], replay
