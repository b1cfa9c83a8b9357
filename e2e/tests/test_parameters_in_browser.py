"""Parameters, home and payload on the page, at desk and phone; judged by what the vehicle holds."""

import os
import secrets
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, ViewportSize, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.direct_station import DirectStation
from dronemap_e2e.impairer import Impairer
from dronemap_e2e.screen import DESK, PHONE, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import InputMethod, Pointer, Station, Touch
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS


@dataclass(frozen=True)
class VehicleUnderTest:
    """One simulated copter with many parameters, and a station plugged into it."""

    simulator: Simulator
    station: DirectStation
    system_id: int
    drone: Json


@pytest.fixture
def vehicle(server: Server, api: Api, tmp_path: Path) -> Iterator[VehicleUnderTest]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--sysid", str(system_id), "--parameters", "300", "--speedup", "5"),
    )
    station = DirectStation(link, system_id)
    drone = wait_for("the vehicle is ready", lambda: api.ready(system_id), 90)
    yield VehicleUnderTest(simulator, station, system_id, drone)
    simulator.stop()
    link.close()


@pytest.fixture
def desk(browser: Browser) -> Iterator[Page]:
    """By day."""
    opened = open_page(browser, DESK)
    yield opened
    opened.context.close()


@pytest.fixture
def phone(browser: Browser) -> Iterator[Page]:
    """By night."""
    opened = open_page(browser, PHONE, touch=True, dark=True)
    yield opened
    opened.context.close()


def open_panel(server: Server, api: Api, page: Page, vehicle: VehicleUnderTest) -> Station:
    name, password = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    input_method: InputMethod = Touch() if page.viewport_size == PHONE else Pointer()
    station = Station(page, input_method)
    station.sign_in(server.address, name, password, secrets.token_hex(10))
    station.choose(vehicle.drone["name"])
    return station


def disclose(station: Station, title: str) -> None:
    # Other buttons may have the word, too, such as what is told of a drone that flies home.
    section = station.page.locator("button[aria-expanded][aria-controls]").filter(has_text=title).first
    station.input_method.press(station.page, section)
    expect(section).to_have_attribute("aria-expanded", "true")


def change_size(station: Station, size: ViewportSize) -> None:
    """The panel is made anew for it, with closed sections."""
    before = station.button("Arm").element_handle()
    assert before
    station.page.set_viewport_size(size)
    before.wait_for_element_state("hidden")
    expect(station.button("Arm")).to_be_visible()


def can_be_pressed(*targets: Locator) -> None:
    """They come into sight, stand still, and nothing lies over them."""
    for target in targets:
        target.click(trial=True)


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def test_parameters_are_read_searched_changed_and_loaded(
    server: Server, api: Api, desk: Page, vehicle: VehicleUnderTest, tmp_path: Path
) -> None:
    """End to end because a browser takes files in and hands them out."""
    page, station = desk, open_panel(server, api, desk, vehicle)
    disclose(station, "Parameters")
    station.press("Read all parameters")
    station.shows("300 parameters, all read at")
    picture(page, "parameters-1-read")

    page.get_by_label("Search by name").fill("alt rtl")
    row = page.get_by_role("list", name="Parameters").get_by_role("button").filter(has_text="RTL_ALT")
    station.input_method.press(page, row)
    field = page.get_by_label("New value of RTL_ALT")
    field.fill("1.5")
    station.shows("It must be a whole number")
    field.fill("2500")
    picture(page, "parameters-2-change")
    station.press("Set")
    station.shows("Change: Done")
    expect(row).to_contain_text("2500")
    assert vehicle.station.parameters()["RTL_ALT"][0] == 2500

    vehicle.simulator.fault(f"{vehicle.system_id} alter RTL_ALT")
    station.input_method.press(page, row)
    field.fill("3000")
    station.press("Set")
    station.shows("The vehicle holds RTL_ALT = 3001, not 3000.")
    vehicle.simulator.fault(f"{vehicle.system_id} repair")

    file = tmp_path / "copter.param"
    file.write_text("RTL_ALT,1800\nLAND_SPEED,60\nFS_EKF_ACTION,1\nNOBODY_KNOWS,1\n")
    page.locator("input[type=file]").set_input_files(file)
    station.shows("2 values differ, 1 is the same.")
    station.shows("The vehicle does not have: NOBODY_KNOWS.")
    station.button("Load 2 values").scroll_into_view_if_needed()
    picture(page, "parameters-3-compared")
    station.hold("Load 2 values")
    station.shows("Change: Done")
    held = vehicle.station.parameters()
    assert (held["RTL_ALT"][0], held["LAND_SPEED"][0]) == (1800, 60)
    with page.expect_download() as saved:
        station.input_method.press(page, page.get_by_role("link", name="Save .param", exact=True))
    lines = Path(saved.value.path()).read_text().splitlines()
    assert "RTL_ALT,1800" in lines

    change_size(station, PHONE)
    disclose(station, "Parameters")
    page.get_by_label("Search by name").fill("alt rtl")
    can_be_pressed(station.button("Read all again"), row)
    row.click()
    field.fill("2500")
    can_be_pressed(station.button("Set"))
    file.write_text("RTL_ALT,1900\nLAND_SPEED,70\n")
    page.locator("input[type=file]").set_input_files(file)
    can_be_pressed(station.button("Load 2 values"), page.get_by_role("link", name="Save .param", exact=True))


def test_home_picture_and_relay_by_page(
    server: Server, api: Api, phone: Page, vehicle: VehicleUnderTest
) -> None:
    """End to end because hands do it on the page, and a second station sees it on the vehicle."""
    page, station = phone, open_panel(server, api, phone, vehicle)
    disclose(station, "Home")
    page.get_by_label("Home at coordinates").fill("47.4012, 8.5501")
    page.get_by_label("Altitude above sea level (m)").fill("501")
    picture(page, "home")
    station.hold("Set home")
    station.shows("Set home: Done")
    assert vehicle.station.home() == (474_012_000, 85_501_000, 501_000)

    disclose(station, "Turn, camera, relays")
    station.press("Take a picture")
    wait_for(
        "the picture is taken", lambda: "pictures 1 " in vehicle.simulator.payload(vehicle.system_id), 30
    )
    page.get_by_label("Relay", exact=True).fill("3")
    station.press("Switch")
    wait_for("it is on", lambda: vehicle.simulator.payload(vehicle.system_id).endswith("relays on: 3"), 30)
    expect(station.button("Turn")).to_have_attribute("aria-disabled", "true")
    picture(page, "payload")

    change_size(station, DESK)
    disclose(station, "Home")
    page.get_by_label("Home at coordinates").fill("47.4013, 8.5502")
    page.get_by_label("Altitude above sea level (m)").fill("502")
    can_be_pressed(station.button("Set home"))
    disclose(station, "Turn, camera, relays")
    page.get_by_label("Relay", exact=True).fill("3")
    can_be_pressed(station.button("Take a picture"), station.button("Switch"))
