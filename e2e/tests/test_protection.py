"""The page keeps to its own policy."""

import secrets
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect

from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station


@pytest.fixture(scope="module")
def configured(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    server = Server(
        tmp_path_factory.mktemp("configured") / "data",
        DRONEMAP_OIDC_ISSUER="http://127.0.0.1:9",
        DRONEMAP_OIDC_ADDRESS="https://drones.example.org",
        DRONEMAP_OIDC_CLIENT_ID="dronemap",
        DRONEMAP_OIDC_NAME="the fleet's login",
    )
    server.start()
    yield server
    server.kill()


def test_page_keeps_content_security_policy_and_offers_provider(configured: Server, browser: Browser) -> None:
    """End to end because a browser is what obeys the policy."""
    page = open_page(browser)
    violations: list[str] = []
    page.on(
        "console", lambda entry: violations.append(entry.text) if "Content Security" in entry.text else None
    )
    page.goto(configured.address)
    expect(page.get_by_role("link", name="Sign in with the fleet's login")).to_be_visible()

    station = Station(page, Pointer())
    station.sign_in(configured.address, "admin", configured.first_password(), secrets.token_hex(10))
    expect(page.locator("canvas").first).to_be_visible(timeout=60_000)
    page.wait_for_timeout(2_000)

    assert not violations
    page.context.close()
