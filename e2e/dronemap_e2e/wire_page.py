"""A person at the page: signs in, flies, plans for several drones, and manages users."""

import re

from playwright.sync_api import Browser, Page, expect

from .screen import open_page
from .station import Pointer, Station
from .wire_clients import NEXT_PASSWORD
from .wire_relay import RecordingRelay

SETTLED_MILLISECONDS = 1500
PLACES = ((-110, -120), (60, -150), (130, -110))


def use_page(relay: RecordingRelay, browser: Browser, password: str, drone: str) -> None:
    page = open_page(browser)
    station = Station(page, Pointer())
    station.sign_in(relay.address, "admin", password, NEXT_PASSWORD)
    station.choose(drone)
    page.wait_for_timeout(SETTLED_MILLISECONDS)
    _fly(station)
    _plan(station)
    _manage(station)
    page.wait_for_timeout(SETTLED_MILLISECONDS)
    page.context.close()


def _fly(station: Station) -> None:
    page = station.page
    station.hold("Arm")
    expect(station.button("Take off")).to_have_attribute("aria-disabled", "false", timeout=20_000)
    page.get_by_label("Take-off altitude (m)").fill("8")
    station.hold("Take off")
    expect(station.button("Land")).to_have_attribute("aria-disabled", "false", timeout=60_000)
    page.wait_for_timeout(SETTLED_MILLISECONDS)
    station.press("Plan mission")
    field = page.get_by_label("Add by coordinates")
    for point in ("47.3979000, 8.5456000", "47.3983000, 8.5462000"):
        field.fill(point)
        station.press("Add")
    station.press("Upload mission")
    page.wait_for_timeout(SETTLED_MILLISECONDS)
    station.press("Land")
    station.shows("Disarmed", 90)
    page.wait_for_timeout(SETTLED_MILLISECONDS)


def _click_places(page: Page) -> None:
    for number, (east, south) in enumerate(PLACES, start=1):
        box = page.get_by_role("application", name="Map").bounding_box()
        assert box
        page.mouse.click(box["x"] + box["width"] / 2 + east, box["y"] + box["height"] / 2 + south)
        expect(page.get_by_text(re.compile(rf"\b{number} waypoints?\b")).first).to_be_visible()


def _plan(station: Station) -> None:
    page = station.page
    page.get_by_role("button").filter(has_text="Multi-drone plan").click()
    _click_places(page)
    page.get_by_role("button").filter(has_text="Options").click()
    page.get_by_label("Search for (s)").fill("1")
    station.press("Select all")
    station.press("Plan")
    plan = page.get_by_role("article", name="Plan")
    expect(plan).to_contain_text("All done after", timeout=60_000)
    page.wait_for_timeout(SETTLED_MILLISECONDS)


def _manage(station: Station) -> None:
    page = station.page
    station.input_method.press(page, page.get_by_role("button", name="Account of admin"))
    station.press("Administration")
    page.wait_for_timeout(SETTLED_MILLISECONDS)
    invitations = page.get_by_role("region", name="Invitations")
    invitations.get_by_label("Whom you invite").fill("Dora")
    invitations.get_by_label("Role of the invited").select_option("viewer")
    invitations.get_by_role("button", name="Make a link").click()
    expect(invitations.get_by_role("status")).to_contain_text("shown this once")
    users = page.get_by_role("region", name="Users")
    row = users.get_by_role("listitem").filter(has_text="ann")
    row.get_by_label("Role of ann").select_option("operator")
    page.wait_for_timeout(SETTLED_MILLISECONDS)
    row.get_by_role("button", name="More for ann").click()
    row.get_by_role("button", name="New one-time password").click()
    expect(users.get_by_role("status").locator("code")).to_be_visible()
