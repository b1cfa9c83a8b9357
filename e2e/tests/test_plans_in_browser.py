"""A mission for several drones on the page: from "Select all" to "Start" in four clicks."""

import os
import secrets
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect, sync_playwright

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station, launch
from dronemap_e2e.waiting import wait_for

DRONES = 3
PLACES = ((-180, -60), (-110, -120), (-30, -150), (60, -150), (130, -110), (170, -40))


@pytest.fixture
def fleet(tmp_path: Path) -> Iterator[Server]:
    """A server of its own, so that all drones are these."""
    server = Server(tmp_path / "data")
    server.start()
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{server.udp_port}",
        *("--count", str(DRONES), "--speedup", "3", "--sysid", "1"),
    )
    yield server
    simulator.stop()
    server.stop()


@pytest.fixture
def page() -> Iterator[Page]:
    with sync_playwright() as playwright:
        browser = launch(playwright)
        yield browser.new_page(viewport={"width": 1440, "height": 900})
        browser.close()


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def _known(api: Api) -> bool:
    drones = [api.ready(system_id) for system_id in range(1, DRONES + 1)]
    return all(d and d["battery"] and d["link"]["quality"]["lossShort"] is not None for d in drones)


def test_an_operator_plans_accepts_and_starts_three_drones(fleet: Server, page: Page) -> None:
    api = Api(fleet.address, fleet.local_key())
    wait_for("all is known", lambda: _known(api), 150)
    name, password = f"operator-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    station = Station(page, Pointer())
    station.sign_in(fleet.address, name, password, secrets.token_hex(10))
    page.get_by_role("button").filter(has_text="Plan for several drones").click()
    box = page.get_by_role("application", name="Map").bounding_box()
    assert box
    for east, north in PLACES:
        page.mouse.click(box["x"] + box["width"] / 2 + east, box["y"] + box["height"] / 2 + north)
        page.wait_for_timeout(400)
    station.shows(f"{len(PLACES)} waypoints")
    picture(page, "plans-1-waypoints")

    station.press("Select all")
    station.press("Plan")
    plan = page.get_by_role("article", name="Plan")
    expect(plan).to_contain_text("All done after", timeout=60_000)
    picture(page, "plans-2-tours")
    station.press("Accept")
    expect(plan.get_by_text("mission on board")).to_have_count(plan.locator("h4").count(), timeout=60_000)
    station.hands.hold(page, station.button("Start"))
    expect(plan.get_by_text("flying").first).to_be_visible(timeout=90_000)
    picture(page, "plans-3-flying")
