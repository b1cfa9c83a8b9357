"""A person brings all drones home, or down, from the map, on a desk and a phone; judged by where they are."""

import secrets
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import pytest
from playwright.sync_api import Browser, ViewportSize, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point
from dronemap_e2e.screen import DESK, PHONE, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import InputMethod, Pointer, Station, Touch
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for
from dronemap_e2e.walker import beside, picture

HEIGHT = 18
NEAR_METRES = 4
DOWN_SECONDS = 240


@dataclass(frozen=True)
class Field:
    """A server that nobody else flies at, with two copters."""

    server: Server
    api: Api
    drones: list[Json]

    def take_off(self) -> None:
        """Each flies to a place away from its home, past the other's."""
        places = []
        for number, drone in enumerate(self.drones):
            height = HEIGHT + 7 * number
            there = beside(drone["home"], 75 - 150 * number, 45)
            wait_for("it may be armed", partial(self.is_ready, drone), 90)
            self.api.do(drone["id"], type="setMode", mode="GUIDED")
            self.api.do(drone["id"], type="arm")
            self.api.do(drone["id"], type="takeOff", altitude=height)
            self.api.do(
                drone["id"],
                type="goTo",
                latitude=there.latitude,
                longitude=there.longitude,
                altitude=height,
                altitudeReference="home",
            )
            places.append(there)
        for drone, there in zip(self.drones, places, strict=True):
            wait_for("it is there", partial(self.is_at, drone, there), 60)
            assert self.api.call("DELETE", f"/drones/{drone['id']}/control").ok

    def is_ready(self, drone: Json) -> bool:
        return bool(self.api.drone(drone["id"])["readyToArm"])

    def is_at(self, drone: Json, place: Point) -> bool:
        position = self.api.drone(drone["id"])["position"]
        return place.metres_to(position["latitude"], position["longitude"]) < NEAR_METRES

    def are_down(self) -> bool:
        return all(self.api.drone(drone["id"])["armed"] is False for drone in self.drones)


@pytest.fixture
def field(own_server: Server, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Field]:
    api = Api(own_server.address, own_server.local_key())
    vehicles = Vehicles(own_server, tmp_path_factory.mktemp("field") / "sim.log")
    ids = [vehicles.wake_next() for _ in range(2)]
    yield Field(
        own_server,
        api,
        [wait_for("a copter is ready", partial(api.ready, one), 90) for one in ids],
    )
    vehicles.close()


def signed_in(field: Field, browser: Browser, hand: InputMethod, size: ViewportSize) -> Station:
    name, password, own = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    answer = field.api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    station = Station(open_page(browser, size, size is PHONE, False), hand)
    station.sign_in(field.server.address, name, password, own)
    return station


def brings_down(station: Station, field: Field, label: str, kind: str) -> None:
    """Shows what would be done, confirms it, and waits until the page says that all are down."""
    page = station.page
    word = label.split()[0].lower()
    station.press(label)
    preview = page.get_by_role("region", name="Preview")
    for drone in field.drones:
        expect(preview).to_contain_text(drone["name"])
    expect(preview.get_by_role("listitem")).to_have_count(2)
    page.wait_for_timeout(1500)
    assert not field.api.get("/recoveries")["recoveries"] or word == "land"
    picture(page, f"recovery-{kind}-{word}-1-preview")
    preview.get_by_role("button", name=label).click()
    recovery = page.get_by_role("region", name="Recovery")
    expect(recovery).to_contain_text("of 2 down", timeout=30_000)
    page.wait_for_timeout(2500)
    picture(page, f"recovery-{kind}-{word}-2-under-way")
    expect(recovery.get_by_role("status")).to_have_text("All are down.", timeout=DOWN_SECONDS * 1000)
    for drone in field.drones:
        line = recovery.get_by_role("listitem").filter(has_text=drone["name"])
        expect(line).to_contain_text("down")
    picture(page, f"recovery-{kind}-{word}-3-outcome")
    assert field.are_down()
    recovery.get_by_role("button", name="Close").click()
    expect(recovery).to_have_count(0)


@pytest.mark.parametrize(("hand", "size"), [(Pointer(), DESK), (Touch(), PHONE)], ids=["desk", "phone"])
def test_a_person_brings_all_drones_home_and_down(
    field: Field, browser: Browser, hand: InputMethod, size: ViewportSize
) -> None:
    """End to end because a person confirms the ways and spots that a browser draws on its map."""
    kind = "phone" if size is PHONE else "desk"
    station = signed_in(field, browser, hand, size)
    field.take_off()
    brings_down(station, field, "Return all", kind)
    for drone in field.drones:
        home = drone["home"]
        assert field.is_at(drone, Point(home["latitude"], home["longitude"], 0))

    field.take_off()
    brings_down(station, field, "Land all", kind)
    landed = next(one for one in field.api.get("/recoveries")["recoveries"] if one["manner"] == "land")
    for one in landed["drones"]:
        spot = Point(one["plan"]["latitude"], one["plan"]["longitude"], 0)
        assert field.is_at({"id": one["drone"]}, spot)
    station.page.context.close()
