"""The server fits into a small machine."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

VEHICLES = 10
MOST_MEGABYTES = 600


def resident_megabytes(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text()
    line = next(line for line in status.splitlines() if line.startswith("VmRSS"))
    return int(line.split()[1]) / 1024


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    started = Server(tmp_path / "data", as_shipped=True)
    started.start()
    yield started
    started.stop()


@pytest.mark.soak
def test_ten_vehicles_need_less_than_600_megabytes(server: Server, tmp_path: Path) -> None:
    api = Api(server.address, server.local_key())
    simulator = Simulator(
        tmp_path / "sim.log", f"udp://127.0.0.1:{server.udp_port}", "--count", "10", "--sysid", "210"
    )
    try:
        wait_for("ten live vehicles", lambda: len(_live(api)) >= VEHICLES or None, 60)
        for _ in range(50):
            api.drones()
        assert resident_megabytes(server.pid) < MOST_MEGABYTES
    finally:
        simulator.stop()


def _live(api: Api) -> list[str]:
    return [d["id"] for d in api.drones() if d["link"]["state"] == "live" and d["position"]]
