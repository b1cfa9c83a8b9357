"""Orders beside flying through SOAP; judged by what the vehicle itself did."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import zeep.exceptions

from dronemap_e2e.api import Api
from dronemap_e2e.direct_station import DirectStation
from dronemap_e2e.impairer import Impairer
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS


@dataclass(frozen=True)
class VehicleUnderTest:
    """One simulated copter, ready to arm, with a station plugged into it."""

    simulator: Simulator
    station: DirectStation
    system_id: int
    drone: str

    def payload(self) -> str:
        return self.simulator.payload(self.system_id)


@pytest.fixture
def vehicle(server: Server, api: Api, tmp_path: Path) -> Iterator[VehicleUnderTest]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    address = f"udp://127.0.0.1:{link.port}"
    simulator = Simulator(tmp_path / "sim.log", address, "--sysid", str(system_id), "--speedup", "5")
    station = DirectStation(link, system_id)
    drone = wait_for("the vehicle is ready", lambda: api.ready(system_id), 90)["id"]
    yield VehicleUnderTest(simulator, station, system_id, drone)
    simulator.stop()
    link.close()


def fault(service: Any, operation: str, **arguments: object) -> zeep.exceptions.Fault:
    with pytest.raises(zeep.exceptions.Fault) as raised:
        getattr(service, operation)(**arguments)
    return raised.value


def result(command: Any) -> str:
    ended: str = command.outcome.result
    return ended


def test_zeep_commands_answers_and_faults(server: Server, api: Api, vehicle: VehicleUnderTest) -> None:
    """End to end because zeep makes calls, and reads answers and faults, by the service's own WSDL."""
    service = soap(server, server.local_key())
    assert (
        result(
            service.setHome(
                droneId=vehicle.drone,
                latitude=47.4013,
                longitude=8.5502,
                altitude=502.0,
                altitudeReference="amsl",
            )
        )
        == "succeeded"
    )
    assert vehicle.station.home() == (474_013_000, 85_502_000, 502_000)
    assert result(service.takePicture(droneId=vehicle.drone)) == "succeeded"
    assert result(service.setRelay(droneId=vehicle.drone, relay=4, setting="toggle")) == "succeeded"
    assert vehicle.payload() == "pictures 1 relays on: 4"
    assert result(service.readParameters(droneId=vehicle.drone)) == "succeeded"
    assert result(service.setParameter(droneId=vehicle.drone, name="RTL_ALT", value=33.0)) == "succeeded"
    found = service.listParameters(droneId=vehicle.drone, search="RTL_ALT").parameters.item
    assert [(p.name, p.value) for p in found] == [("RTL_ALT", 33.0)]
    assert vehicle.station.parameters()["RTL_ALT"][0] == 33.0

    bad = {"type": "goTo", "latitude": 95, "longitude": 8, "altitude": 20}
    by_rest = api.call("POST", f"/drones/{vehicle.drone}/commands", bad).json()["detail"]
    latitude = fault(service, "goto", droneId=vehicle.drone, latitude=95, longitude=8, altitude=20)
    assert latitude.message == by_rest
    assert latitude.code.endswith(":Client")
    assert "nosuchdrone" in fault(service, "arm", droneId="nosuchdrone").message
    for key, words in (("wrong", "key"), (api.new_key("soap viewer", "viewer"), "operator")):
        assert words in fault(soap(server, key), "arm", droneId=vehicle.drone).message
    assert api.drone(vehicle.drone)["armed"] is False
