"""People come in, are given rights and lose them, each on a page of their own; at desk and phone."""

import os
import re
import secrets
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, WebSocketRoute, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import DESK, PHONE, also_at, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station, Touch
from dronemap_e2e.waiting import wait_for

PATIENCE = 30_000


class UserPages:
    """Pages of several users, which share nothing: light at a desk, dark on a phone."""

    def __init__(self, browser: Browser) -> None:
        self._browser = browser
        self.stations: list[Station] = []

    def on_desk(self) -> Station:
        return self._add(Station(open_page(self._browser, DESK), Pointer()))

    def on_phone(self) -> Station:
        return self._add(Station(open_page(self._browser, PHONE, touch=True, dark=True), Touch()))

    def _add(self, station: Station) -> Station:
        self.stations.append(station)
        return station


@pytest.fixture
def pages(browser: Browser) -> Iterator[UserPages]:
    together = UserPages(browser)
    yield together
    for station in together.stations:
        station.page.context.close()


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def new_name(kind: str) -> str:
    return f"{kind}-{secrets.token_hex(4)}"


def administrator(server: Server, api: Api, station: Station) -> Station:
    """Signed in and at the page of users."""
    name, password = new_name("chief"), secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "administrator"})
    assert answer.status_code == 201, answer.text
    station.sign_in(server.address, name, password, secrets.token_hex(10))
    station.input_method.press(station.page, station.page.get_by_role("button", name=f"Account of {name}"))
    station.press("Administration")
    return station


def card(station: Station, name: str) -> Locator:
    return station.page.get_by_role("region", name=name)


def row(station: Station, user: str) -> Locator:
    return card(station, "Users").get_by_role("listitem").filter(has_text=user)


def press_in(station: Station, where: Locator, label: str | re.Pattern[str]) -> None:
    station.input_method.press(station.page, where.get_by_role("button", name=label))


def test_buttons_do_not_move_when_connection_line_appears(server: Server, api: Api, pages: UserPages) -> None:
    """End to end because only a browser lays a page out."""
    name, password = new_name("viewer"), secrets.token_hex(10)
    made = api.call("POST", "/users", {"name": name, "password": password, "role": "viewer"})
    assert made.status_code == 201, made.text
    station = pages.on_phone()
    waiting: list[WebSocketRoute] = []
    station.page.route_web_socket(re.compile("^wss?:"), lambda socket: waiting.append(socket))
    station.sign_in(server.address, name, password, secrets.token_hex(10))
    menu = station.page.get_by_role("button", name=f"Account of {name}")
    expect(station.page.get_by_text("Connecting…")).to_be_visible()
    before = menu.bounding_box()
    # What the browser tells is heard while it is asked something, and not in a plain wait.
    wait_for("the page asks for its line", lambda: station.page.title() and waiting, 20)
    waiting[-1].connect_to_server()
    expect(station.page.get_by_text(re.compile(r"^\d+ drones?$"))).to_be_visible()
    assert menu.bounding_box() == before


def reload_users(station: Station) -> None:
    press_in(station, station.page.get_by_role("main"), "Back to the map")
    station.input_method.press(
        station.page, station.page.get_by_role("button", name=re.compile("^Account of chief-"))
    )
    station.press("Administration")


def test_invited_viewer_sees_drones_until_disabled(
    server: Server, api: Api, copter: Json, pages: UserPages
) -> None:
    """End to end because two people have pages of their own, and one of them loses what it shows."""
    chief = administrator(server, api, pages.on_desk())
    invitations = card(chief, "Invitations")
    invitations.get_by_label("Whom you invite").fill("Ann of the fire brigade")
    invitations.get_by_label("Role of the invited").select_option("viewer")
    make = invitations.get_by_role("button", name="Make a link")
    also_at(chief.page, PHONE, make)
    chief.input_method.press(chief.page, make)
    expect(invitations.get_by_role("status")).to_contain_text("shown this once")
    picture(chief.page, "accounts-1-invited")
    link = invitations.get_by_role("status").locator("code").inner_text()
    assert link.startswith(server.address + "/#invitation=")

    ann, password = new_name("ann"), secrets.token_hex(10)
    guest = pages.on_phone()
    guest.page.goto(link)
    expect(guest.page.get_by_role("heading", name="You are invited")).to_be_visible()
    guest.page.get_by_label("User name").fill(ann)
    guest.page.get_by_label("Password", exact=True).fill(password)
    picture(guest.page, "accounts-2-invitation")
    also_at(guest.page, DESK, guest.button("Create account"))
    guest.press("Create account")
    guest.choose(copter["name"])
    expect(guest.button("Arm")).to_have_attribute("aria-disabled", "true")
    guest.shows("Your role may look, not command")
    expect(guest.page.get_by_role("button", name=f"Rename {copter['name']}")).to_have_count(0)
    picture(guest.page, "accounts-3-viewer")

    again = pages.on_phone()
    again.page.goto(link)
    again.page.get_by_label("User name").fill(new_name("bob"))
    again.page.get_by_label("Password", exact=True).fill(password)
    again.press("Create account")
    again.shows("This invitation was used already, has expired or was withdrawn")

    reload_users(chief)
    press_in(chief, row(chief, ann), f"More for {ann}")
    picture(chief.page, "accounts-4-more")
    chief.hold(f"Disable {ann}")
    expect(row(chief, ann)).to_contain_text("disabled", timeout=PATIENCE)
    guest.shows("You were signed out.")
    expect(guest.page.get_by_text(copter["name"])).to_have_count(0)
    picture(guest.page, "accounts-5-signed-out")
    guest.page.get_by_label("User name").fill(ann)
    guest.page.get_by_label("Password", exact=True).fill(password)
    guest.press("Sign in")
    guest.shows("Your account has been disabled; ask an administrator.")


def test_requested_account_is_approved_and_gets_role_and_password(
    server: Server, api: Api, copter: Json, pages: UserPages
) -> None:
    """End to end because the pages of two people change with what one does on the other."""
    carol, password = new_name("carol"), secrets.token_hex(10)
    guest = pages.on_desk()
    guest.page.goto(server.address)
    guest.press("No account yet? Ask for one")
    guest.page.get_by_label("User name").fill(carol)
    guest.page.get_by_label("Password", exact=True).fill(password)
    picture(guest.page, "accounts-6-asks")
    also_at(guest.page, PHONE, guest.button("Ask for an account"))
    guest.press("Ask for an account")
    guest.shows("When an administrator has approved it")
    picture(guest.page, "accounts-7-waits")
    guest.press("Back to the sign-in")
    guest.page.get_by_label("User name").fill(carol)
    guest.page.get_by_label("Password", exact=True).fill(password)
    guest.press("Sign in")
    guest.shows("Your account waits until an administrator lets you in")

    chief = administrator(server, api, pages.on_phone())
    expect(row(chief, carol)).to_contain_text("waits for approval")
    picture(chief.page, "accounts-8-users")
    press_in(chief, row(chief, carol), re.compile("^Approve"))
    expect(row(chief, carol)).not_to_contain_text("waits", timeout=PATIENCE)
    guest.press("Sign in")
    guest.choose(copter["name"])
    expect(guest.button("Arm")).to_have_attribute("aria-disabled", "true")

    # The open page follows the new role by itself.
    row(chief, carol).get_by_label(f"Role of {carol}").select_option("operator")
    expect(guest.button("Arm")).to_have_attribute("aria-disabled", "false", timeout=PATIENCE)

    press_in(chief, row(chief, carol), f"More for {carol}")
    press_in(chief, row(chief, carol), "New one-time password")
    shown = card(chief, "Users").get_by_role("status").locator("code")
    expect(shown).to_be_visible()
    one_time = shown.inner_text()
    guest.shows("You were signed out.")
    guest.page.get_by_label("User name").fill(carol)
    guest.page.get_by_label("Password", exact=True).fill(one_time)
    guest.press("Sign in")
    expect(guest.page.get_by_label("New password")).to_be_visible()
    picture(guest.page, "accounts-9-own-password")
    guest.page.get_by_label("New password").fill(secrets.token_hex(10))
    guest.press("Save and continue")
    guest.choose(copter["name"])

    row(chief, carol).get_by_label(f"Role of {carol}").select_option("reporter")
    expect(guest.page.get_by_role("heading", name="You are signed in")).to_be_visible(timeout=PATIENCE)
    expect(guest.page.get_by_text(copter["name"])).to_have_count(0)
    picture(guest.page, "accounts-10-reporter")


def test_access_key_for_one_drone_is_created_renewed_and_revoked(
    server: Server, api: Api, copter: Json, pages: UserPages
) -> None:
    """End to end because a key that a page shows once is used by a program."""
    station = administrator(server, api, pages.on_phone())
    keys = card(station, "Access keys")
    keys.get_by_label("What the key is for").fill("survey script")
    keys.get_by_label("What it may do").select_option("only look")
    keys.get_by_label("For which drones").select_option("only some")
    keys.get_by_label(copter["name"], exact=True).check()
    picture(station.page, "accounts-11-key")
    also_at(station.page, DESK, keys.get_by_role("button", name="Create key"))
    press_in(station, keys, "Create key")
    made = keys.get_by_role("status").locator("code")
    expect(made).to_be_visible()
    program = Api(server.address, made.inner_text())
    assert [drone["id"] for drone in program.drones()] == [copter["id"]]
    refused = program.call("POST", f"/drones/{copter['id']}/commands", {"type": "arm"})
    assert refused.status_code == 403, refused.text

    line = keys.get_by_role("listitem").filter(has_text="survey script")
    expect(line).to_contain_text(copter["name"])
    changes = [line.get_by_role("button", name=re.compile(name)) for name in ("^Renew", "^Revoke")]
    also_at(station.page, DESK, *changes)
    station.input_method.hold(station.page, line.get_by_role("button", name=re.compile("^Renew")))
    expect(made).not_to_have_text(program.key or "", timeout=PATIENCE)
    assert program.call("GET", "/drones").status_code == 401
    renewed = Api(server.address, made.inner_text())
    assert renewed.call("GET", "/drones").status_code == 200

    station.input_method.hold(station.page, line.get_by_role("button", name=re.compile("^Revoke")))
    expect(line).to_have_count(0, timeout=PATIENCE)
    assert renewed.call("GET", "/drones").status_code == 401
