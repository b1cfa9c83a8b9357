"""Long runs, by `./dronemap soak` only."""

from pathlib import Path

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import throughout, wait_for

from .test_footprint import resident_megabytes

VEHICLES = 500
MINUTES = 10


@pytest.mark.soak
def test_five_hundred_vehicles_stay_live_in_flat_memory(server: Server, api: Api, tmp_path: Path) -> None:
    simulator = Simulator(
        tmp_path / "sim.log", f"udp://127.0.0.1:{server.udp_port}", "--count", str(VEHICLES)
    )
    try:
        wait_for("all are live", lambda: _live(api) >= VEHICLES, 120)
        after_warm_up = resident_megabytes(server.pid)
        throughout("all are live", lambda: _live(api) >= VEHICLES, MINUTES * 60, every=5)
        assert resident_megabytes(server.pid) < after_warm_up * 1.25
    finally:
        simulator.stop()


def _live(api: Api) -> int:
    return sum(d["link"]["state"] == "live" for d in api.drones())
