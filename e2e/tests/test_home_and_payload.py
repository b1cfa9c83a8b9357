"""Home, turns, pictures and relays, through REST and SOAP; judged by what the vehicle itself did."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.impairer import Impairer, Weather
from dronemap_e2e.plugged import PluggedStation
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS


@dataclass(frozen=True)
class Bench:
    """One simulated vehicle, ready to arm, with a station plugged into it."""

    api: Api
    simulator: Simulator
    link: Impairer
    station: PluggedStation
    system_id: int
    drone: Json

    @property
    def id(self) -> str:
        drone: str = self.drone["id"]
        return drone

    def heading(self) -> float:
        heading: float = self.api.drone(self.id)["motion"]["heading"]
        return heading


@pytest.fixture(params=["arducopter", "px4"])
def bench(request: pytest.FixtureRequest, server: Server, api: Api, tmp_path: Path) -> Iterator[Bench]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--sysid", str(system_id), "--personality", request.param),
    )
    station = PluggedStation(link, system_id)
    drone = wait_for("the vehicle is ready", lambda: api.ready(system_id), 90)
    yield Bench(api, simulator, link, station, system_id, drone)
    simulator.stop()
    link.close()


def test_home_goes_where_it_is_put_and_is_shown_there(bench: Bench, server: Server) -> None:
    there = {"latitude": 47.4012, "longitude": 8.5501, "altitude": 501.0}
    bench.link.weather = Weather(delay=0.2, jitter=0.1, loss=0.1)
    bench.api.do(bench.id, type="setHome", altitudeReference="amsl", **there)
    assert bench.station.home() == (474_012_000, 85_501_000, 501_000)
    shown = wait_for("the page can show it", lambda: _home_at(bench, 501), 30)
    assert (shown["latitude"], shown["longitude"]) == (47.4012, 8.5501)

    answer = soap(server, server.local_key()).setHome(bench.id, 47.4013, 8.5502, 502.0)
    assert answer.result == "succeeded", answer
    assert bench.station.home() == (474_013_000, 85_502_000, 502_000)

    bench.api.do(bench.id, type="setHome")
    here = bench.api.drone(bench.id)["position"]
    latitude, longitude, _ = bench.station.home()
    assert (latitude / 1e7, longitude / 1e7) == pytest.approx((here["latitude"], here["longitude"]), abs=1e-5)
    bench.api.do(bench.id, type="readHome")


def _home_at(bench: Bench, altitude: float) -> Json | None:
    home: Json | None = bench.api.drone(bench.id)["home"]
    return home if home and home["altitudeAmsl"] == altitude else None


def test_half_a_home_is_refused_before_anything_is_sent(bench: Bench) -> None:
    before = bench.station.home()

    half = bench.api.call("POST", f"/drones/{bench.id}/commands", {"type": "setHome", "latitude": 47.4})

    assert (half.status_code, half.json()["field"]) == (422, "longitude")
    assert bench.station.home() == before


def test_every_picture_and_switched_relay_is_one_on_the_vehicle(bench: Bench, server: Server) -> None:
    services = soap(server, server.local_key())
    bench.api.do(bench.id, type="takePicture")
    assert services.takePicture(bench.id).result == "succeeded"
    assert "pictures 2 " in bench.simulator.payload(bench.system_id)

    if bench.drone["autopilot"] == "PX4":
        refused = bench.api.call("POST", f"/drones/{bench.id}/commands", _relay(1, "on"))
        assert refused.status_code == 409
        assert "cannot switch a relay" in refused.json()["detail"]
        return
    bench.api.do(bench.id, **_relay(1, "on"))
    assert services.setRelay(bench.id, 4, "toggle").result == "succeeded"
    assert bench.simulator.payload(bench.system_id) == "pictures 2 relays on: 1 4"
    bench.api.do(bench.id, **_relay(1, "off"))
    assert bench.simulator.payload(bench.system_id) == "pictures 2 relays on: 4"
    missing = bench.api.command(bench.id, _relay(9, "on"))
    assert (missing["outcome"]["result"], missing["outcome"]["by"]) == ("refused", "vehicle")


def _relay(relay: int, setting: str) -> Json:
    return {"type": "setRelay", "relay": relay, "setting": setting}


@pytest.mark.parametrize("bench", ["arducopter"], indirect=True)
def test_a_turn_is_flown_at_a_rate_and_the_way_round_that_was_asked_for(bench: Bench) -> None:
    bench.api.do(bench.id, type="setMode", mode="GUIDED")
    bench.api.do(bench.id, type="arm")
    bench.api.do(bench.id, type="takeOff", altitude=10)
    wait_for("it is up", lambda: (_height(bench) or 0) > 9, 60)
    before = bench.heading()

    bench.api.do(bench.id, type="turn", degrees=-270)

    passed: list[float] = []

    def arrived() -> bool:
        turned = (before - bench.heading()) % 360
        passed.append(turned)
        return 268 <= turned <= 272

    wait_for("it has turned three quarters to the left", arrived, 40)
    assert any(60 < turned < 200 for turned in passed), "it did not turn to the left"


def _height(bench: Bench) -> float | None:
    height: float | None = bench.api.drone(bench.id)["position"]["altitudeAboveHome"]
    return height


def test_parameters_by_soap(bench: Bench, server: Server) -> None:
    services = soap(server, server.local_key())
    assert services.readParameters(bench.id).result == "succeeded"
    name = "RTL_ALT" if bench.drone["autopilot"] == "ArduPilot" else "RTL_RETURN_ALT"

    assert services.setParameter(bench.id, name, 33.0).result == "succeeded"

    found = services.getParameters(bench.id, name)
    assert [(p.name, p.value) for p in found] == [(name, 33.0)]
    assert bench.station.parameters()[name][0] == 33.0
