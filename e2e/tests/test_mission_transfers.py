"""A long mission over a bad link: what the vehicle holds is what was sent."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.direct_station import DirectStation
from dronemap_e2e.impairer import BAD, UNIMPAIRED, Impairer
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

HOME = (47.3977, 8.5456)


@dataclass(frozen=True)
class VehicleUnderTest:
    """One simulated vehicle behind a link that a test may spoil, with a station plugged into it."""

    api: Api
    link: Impairer
    station: DirectStation
    drone: str

    def begin_upload(self, items: list[Json]) -> str:
        answer = self.api.call(
            "POST", f"/drones/{self.drone}/commands", {"type": "uploadMission", "items": items}
        )
        assert answer.status_code == 202, answer.text
        command: str = answer.json()["id"]
        return command

    def holds(self, items: list[Json]) -> bool:
        """True if the vehicle itself has these waypoints in this order, whatever stands before them."""
        held = [(i.x, i.y, round(i.z)) for i in self.station.mission()]
        sent = [(round(i["latitude"] * 1e7), round(i["longitude"] * 1e7), i["altitude"]) for i in items]
        return held[-len(sent) :] == sent


@pytest.fixture(params=["arducopter", "px4"])
def vehicle(
    request: pytest.FixtureRequest, server: Server, api: Api, tmp_path: Path
) -> Iterator[VehicleUnderTest]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--sysid", str(system_id), "--personality", request.param),
    )
    station = DirectStation(link, system_id)
    drone = wait_for("the vehicle is ready", lambda: api.ready(system_id), 90)["id"]
    yield VehicleUnderTest(api, link, station, drone)
    simulator.stop()
    link.close()


def waypoints(count: int, seed: int = 0) -> list[Json]:
    return [
        {
            "type": "waypoint",
            "latitude": round(HOME[0] + (number + 1 + seed) * 1e-5, 7),
            "longitude": round(HOME[1] + (number % 7) * 2e-5, 7),
            "altitude": 20 + number % 30,
        }
        for number in range(count)
    ]


@pytest.mark.soak
@pytest.mark.parametrize(("count", "seconds"), [(200, 1800)], ids=["200 items"])
def test_mission_upload_over_bad_link(vehicle: VehicleUnderTest, count: int, seconds: float) -> None:
    items = waypoints(count)
    vehicle.link.conditions = BAD

    outcome = vehicle.api.ended(vehicle.begin_upload(items), seconds)["outcome"]

    assert outcome["result"] == "succeeded", outcome
    vehicle.link.conditions = UNIMPAIRED
    assert vehicle.holds(items)
