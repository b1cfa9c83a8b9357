"""Bad input on the page: the sentence stands where the control is, and nothing goes to the vehicle."""

import secrets
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station


def sent(wire: VehicleMessages) -> list[Any]:
    """Commands and mission items that went down to the vehicle, message requests aside."""
    return [
        h.message
        for h in wire.messages("COMMAND_LONG", "COMMAND_INT", "MISSION_COUNT", "MISSION_ITEM_INT", up=False)
        if getattr(h.message, "command", None) not in (511, 512, 519, 520)
    ]


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


def user(api: Api, role: str) -> tuple[str, str]:
    name, password = f"{role}-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": role})
    assert answer.status_code == 201, answer.text
    return name, password


def test_wrong_password_is_reported(server: Server, page: Page) -> None:
    """End to end because a person reads it on the page."""
    page.goto(server.address)
    page.get_by_label("User name").fill("admin")
    page.get_by_label("Password", exact=True).fill("certainly wrong")
    page.get_by_role("button", name="Sign in", exact=True).click()

    expect(page.get_by_role("alert")).to_contain_text("password")


def test_viewer_is_shown_why_arming_is_refused(
    server: Server, api: Api, wire: VehicleMessages, copter: Json, page: Page
) -> None:
    """End to end because a browser holds the button, and nothing goes over the wire."""
    station = Station(page, Pointer())
    station.sign_in(server.address, *user(api, "viewer"), secrets.token_hex(10))
    station.choose(copter["name"])

    expect(station.button("Arm")).to_have_attribute("aria-disabled", "true")
    station.shows("Viewers watch only")
    station.input_method.hold(page, station.button("Arm"))
    assert not sent(wire)


def test_invalid_waypoints_are_not_uploaded(
    server: Server, api: Api, wire: VehicleMessages, copter: Json, page: Page
) -> None:
    """End to end because a browser keeps them, and nothing goes over the wire."""
    station = Station(page, Pointer())
    station.sign_in(server.address, *user(api, "operator"), secrets.token_hex(10))
    station.choose(copter["name"])
    station.press("Plan mission")
    page.get_by_label("Add by coordinates").fill("95, 8.5")
    station.press("Add")
    expect(page.get_by_role("alert")).to_contain_text("95, 8.5")
    page.get_by_label("Waypoint altitude (m)").fill("")
    page.get_by_label("Add by coordinates").fill("47.3977, 8.5456")
    station.press("Add")

    expect(station.button("Upload mission")).to_have_attribute("aria-disabled", "true")
    station.shows("must be -500 to 10000 m")
    assert not sent(wire)
