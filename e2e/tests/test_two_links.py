"""One vehicle on two links at once: one drone, spoken to over the better link, whichever of them breaks."""

import contextlib
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.carriers import Bridge, Carrier, Dtls, Together, UdpCaller
from dronemap_e2e.impairer import CLEAR, CUT, Impairer, Weather
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import rounds, wait_for

from .conftest import SYSTEM_IDS
from .test_links import endpoint, go_and_land, take_off

WORSE = Weather(delay=0.15, jitter=0.05, loss=0.2)
# The share of lost messages is looked at over some seconds before the way is changed.
LONGEST_CHOICE = 60.0


@dataclass
class Way:
    """One of the two links: its weather, and the port that the server knows it by."""

    weather: Impairer
    caller: int

    @property
    def port(self) -> int:
        return self.weather.seen_by_server(self.caller)


@dataclass
class OnTwoLinks:
    """A simulated copter, and its drone as it was when both links were known."""

    one: Way
    other: Way
    drone: str
    system_id: int

    def split(self, link: Json) -> tuple[Way, Way]:
        """The way that is spoken on, and the one that is not."""
        chosen = link["port"]
        return (self.one, self.other) if chosen == self.one.port else (self.other, self.one)


@contextlib.contextmanager
def copter_on(api: Api, carrier: Carrier, log: Path) -> Iterator[Json]:
    system_id = next(SYSTEM_IDS)
    bridge = Bridge(carrier)
    simulator = Simulator(
        log,
        f"udp://127.0.0.1:{bridge.port}",
        *("--count", "1", "--speedup", "4", "--sysid", str(system_id)),
    )
    try:
        yield wait_for("the copter is ready to arm", lambda: api.ready(system_id), 90)
    finally:
        simulator.stop()
        bridge.close()


def both(api: Api, drone: str) -> Json | None:
    link: Json = api.drone(drone)["link"]
    return link if len(link["others"]) == 1 else None


@pytest.fixture
def by_dtls(api: Api, tmp_path: Path) -> Iterator[OnTwoLinks]:
    """Two DTLS links with one vehicle's key."""
    key = api.call("POST", "/dtls-keys", {"label": "copter on two links"}).json()
    with endpoint(api, "dtlsserver://127.0.0.1:0") as opened:
        port = int(opened["url"].rsplit(":", 1)[1])
        weathers = [Impairer(port), Impairer(port)]
        callers = [Dtls(w.port, key["identity"], key["secret"]) for w in weathers]
        with copter_on(api, Together(*callers), tmp_path / "sim.log") as drone:
            wait_for("both links are known", lambda: both(api, drone["id"]), 30)
            one, other = (Way(w, c.client.port) for w, c in zip(weathers, callers, strict=True))
            yield OnTwoLinks(one, other, drone["id"], drone["link"]["systemId"])
        for weather in weathers:
            weather.close()


@pytest.fixture
def signed(server: Server, api: Api, tmp_path: Path) -> Iterator[OnTwoLinks]:
    """Two UDP links with messages that the vehicle's key has signed."""
    weathers = [Impairer(server.udp_port), Impairer(server.udp_port)]
    callers = [UdpCaller(w.port) for w in weathers]
    weathers[1].weather = CUT
    with copter_on(api, Together(*callers), tmp_path / "sim.log") as drone:
        path = f"/drones/{drone['id']}"
        assert api.call("POST", f"{path}/link-key", {}).status_code == 201
        answer = api.call("POST", f"{path}/link-key/install")
        assert answer.status_code == 200 and answer.json()["key"]["inUse"], answer.text
        assert api.call("PUT", f"{path}/link-security", {"policy": "required"}).status_code == 200
        # The first to bring a signed message has shown something; copies that come later have not.
        weathers[0].weather = Weather(delay=0.1)
        weathers[1].weather = CLEAR
        wait_for("both links are known", lambda: both(api, drone["id"]), 30)
        weathers[0].weather = CLEAR
        one, other = (Way(w, c.port) for w, c in zip(weathers, callers, strict=True))
        yield OnTwoLinks(one, other, drone["id"], drone["link"]["systemId"])
    for weather in weathers:
        weather.close()


def uses(api: Api, vehicle: OnTwoLinks, way: Way) -> bool:
    port: int = api.drone(vehicle.drone)["link"]["port"]
    return port == way.port


def stays(api: Api, vehicle: OnTwoLinks, seconds: float) -> None:
    """It is one drone, and never lost."""
    for _ in rounds(time.monotonic() + seconds, 0.1):
        found = [d for d in api.drones() if d["link"]["systemId"] == vehicle.system_id]
        assert [d["id"] for d in found] == [vehicle.drone]
        assert found[0]["link"]["state"] != "lost"


def flies_on_whichever_link_is_left(api: Api, vehicle: OnTwoLinks) -> None:
    take_off(api, vehicle.drone)
    used, spare = vehicle.split(api.drone(vehicle.drone)["link"])

    # The way in use becomes the worse one: the other is taken.
    used.weather.weather = WORSE
    wait_for("the better link is used", lambda: uses(api, vehicle, spare), LONGEST_CHOICE)
    worse, better = used, spare

    # The worse one is cut: nothing changes for anybody.
    worse.weather.weather = CUT
    api.do(vehicle.drone, type="hold")
    stays(api, vehicle, 7)
    assert uses(api, vehicle, better)

    # It comes back, and the better one is cut in flight: the command given at that moment arrives.
    worse.weather.weather = WORSE
    wait_for("the worse link is heard again", lambda: both(api, vehicle.drone), 30)
    better.weather.weather = CUT
    api.do(vehicle.drone, type="setMode", mode="GUIDED")
    stays(api, vehicle, 7)
    assert uses(api, vehicle, worse)

    go_and_land(api, vehicle.drone)
    stays(api, vehicle, 0.1)


def test_a_dtls_vehicle_on_two_links_is_one_drone_on_the_better_one(api: Api, by_dtls: OnTwoLinks) -> None:
    flies_on_whichever_link_is_left(api, by_dtls)


def test_a_signed_vehicle_on_two_links_is_one_drone_on_the_better_one(api: Api, signed: OnTwoLinks) -> None:
    flies_on_whichever_link_is_left(api, signed)
