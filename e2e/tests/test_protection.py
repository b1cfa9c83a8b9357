"""A server with tight bounds cuts slow and greedy clients; the page keeps to its own policy."""

import secrets
import socket
from collections.abc import Iterator

import pytest
import requests
from playwright.sync_api import expect, sync_playwright

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station, launch
from dronemap_e2e.waiting import wait_for


@pytest.fixture(scope="module")
def strict(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    server = Server(
        tmp_path_factory.mktemp("strict") / "data",
        DRONEMAP_SLOW_CLIENT_SECONDS="2",
        DRONEMAP_RATE_REQUESTS="20",
        DRONEMAP_OIDC_ISSUER="http://127.0.0.1:9",
        DRONEMAP_OIDC_ADDRESS="https://drones.example.org",
        DRONEMAP_OIDC_CLIENT_ID="dronemap",
        DRONEMAP_OIDC_NAME="the fleet's login",
    )
    server.start()
    yield server
    server.kill()


def closed(client: socket.socket) -> bool:
    try:
        client.sendall(b"a")
        client.settimeout(0.01)
        return client.recv(4096) == b""
    except TimeoutError:
        return False
    except OSError:
        return True


def test_slow_clients_are_cut_and_others_served(strict: Server) -> None:
    slow = [
        socket.create_connection(("127.0.0.1", port)) for port in 50 * [strict.http_port, strict.stream_port]
    ]
    for client in slow:
        client.sendall(b"GET /api/v1/health HTTP/1.1\r\nHost: localhost\r\nX-Slow: ")

    def all_cut() -> bool:
        assert requests.get(strict.address + "/api/v1/health", timeout=20).ok
        return all([closed(client) for client in slow])

    wait_for("all are cut", all_cut, 60)


def test_a_greedy_user_is_told_to_wait_and_others_are_not(strict: Server) -> None:
    greedy = Api(strict.address, strict.local_key())

    refused = next(
        answer
        for answer in (greedy.call("GET", "/drones") for _ in range(3_000))
        if answer.status_code == 429
    )

    assert int(refused.headers["Retry-After"]) >= 1
    assert "requests a second" in refused.json()["detail"]
    assert requests.get(strict.address + "/api/v1/health", timeout=20).ok


def test_the_page_keeps_to_its_own_policy_and_offers_the_provider(strict: Server) -> None:
    with sync_playwright() as playwright:
        browser = launch(playwright)
        page = browser.new_context(viewport={"width": 1440, "height": 900}).new_page()
        violations: list[str] = []
        page.on(
            "console", lambda said: violations.append(said.text) if "Content Security" in said.text else None
        )
        page.goto(strict.address)
        expect(page.get_by_role("link", name="Sign in with the fleet's login")).to_be_visible()

        station = Station(page, Pointer())
        station.sign_in(strict.address, "admin", strict.first_password(), secrets.token_hex(10))
        expect(page.locator("canvas").first).to_be_visible(timeout=60_000)
        page.wait_for_timeout(2_000)

        assert not violations
        browser.close()
