"""Many parameters over a bad link."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.direct_station import DirectStation
from dronemap_e2e.impairer import BAD, UNIMPAIRED, Impairer
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

COUNT = 1000


@dataclass(frozen=True)
class VehicleUnderTest:
    """One simulated vehicle behind a link that a test may spoil, with a station plugged into it."""

    api: Api
    link: Impairer
    station: DirectStation
    drone: str

    @property
    def path(self) -> str:
        return f"/drones/{self.drone}/parameters"

    def read(self) -> None:
        record = self.api.call("POST", self.path + "/refresh?wait=60", None).json()
        assert record["outcome"] == {"result": "succeeded", "by": None, "reason": None}, record
        assert record["progress"]["done"] == record["progress"]["total"] == COUNT


@pytest.fixture(params=["arducopter", "px4"])
def vehicle(
    request: pytest.FixtureRequest, server: Server, api: Api, tmp_path: Path
) -> Iterator[VehicleUnderTest]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--sysid", str(system_id), "--personality", request.param, "--parameters", str(COUNT)),
    )
    station = DirectStation(link, system_id)

    def listed() -> str | None:
        return next((d["id"] for d in api.drones() if d["link"]["systemId"] == system_id), None)

    drone = wait_for("the vehicle is listed", listed, 60)
    yield VehicleUnderTest(api, link, station, drone)
    simulator.stop()
    link.close()


@pytest.mark.soak
@pytest.mark.parametrize("vehicle", ["arducopter"], indirect=True)
def test_thousand_parameters_over_bad_link(vehicle: VehicleUnderTest) -> None:
    vehicle.read()
    names = [p["name"] for p in vehicle.api.get(vehicle.path + "?search=SPARE")["parameters"]]
    file = "\n".join(f"{name},{number % 120}" for number, name in enumerate(names))
    vehicle.link.conditions = BAD

    loading = vehicle.api.post_text(vehicle.path + "/file", file).json()["command"]

    assert vehicle.api.ended(loading["id"], 600)["outcome"]["result"] == "succeeded"
    vehicle.link.conditions = UNIMPAIRED
    held = vehicle.station.parameters()
    assert [held[name][0] for name in names] == [number % 120 for number in range(len(names))]
