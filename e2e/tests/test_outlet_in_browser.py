"""The outlet on the page: a passphrase made there lets a program attach, a button ends it."""

import secrets
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from dronemap_e2e.api import Api
from dronemap_e2e.ground_station import GroundStation
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


def test_client_attaches_with_passphrase_from_page_and_is_disconnected_there(
    server: Server, api: Api, page: Page
) -> None:
    """End to end because it is about a page in a browser, and pymavlink signs with what is shown there."""
    name, password = f"attached-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "administrator"})
    assert answer.status_code == 201, answer.text
    station = Station(page, Pointer())
    station.sign_in(server.address, name, password, secrets.token_hex(10))
    page.get_by_role("button", name=f"Account of {name}").click()
    station.press("Administration")

    own = page.get_by_role("region", name="Your own ground station")
    expect(own).to_contain_text(f"UDP 127.0.0.1:{server.outlet_udp_port}")
    station.press("Make a passphrase")
    passphrase = own.get_by_role("status").locator("code").inner_text()
    own.get_by_role("button", name="pymavlink").click()
    expect(own).to_contain_text(f'hashlib.sha256(b"{passphrase}").digest()')

    scrolls = "document.documentElement.scrollHeight > innerHeight"
    assert not page.evaluate(scrolls), "what is hidden for the eye makes the page longer than the window"

    ground = GroundStation(f"udpout:127.0.0.1:{server.outlet_udp_port}", passphrase)
    try:
        attached = page.get_by_role("region", name="Attached ground stations").get_by_role("listitem")
        mine = attached.filter(has_text=name)
        expect(mine).to_contain_text("messages/s to it", timeout=10_000)
        expect(mine).not_to_contain_text(", 0/s from it", timeout=10_000)
        station.input_method.hold(page, mine.get_by_role("button"))
        expect(mine).to_have_count(0, timeout=10_000)
        clients = api.get("/outlet/clients")["clients"]
        assert name not in {client["user"] for client in clients}
    finally:
        ground.close()
