"""A phone trusts the server by the steps of the guide; its bearer asks for a drone, walks, pauses, stops."""

import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Error, Playwright, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.certificates import NAME, make_certificate, trust_certificate
from dronemap_e2e.flight import Point
from dronemap_e2e.ports import free_port
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Touch, launch
from dronemap_e2e.waiting import wait_for
from dronemap_e2e.walker import Walker, beside, open_phone_page, picture, sign_in

SYSTEM_ID = 77
STEADY = 4
"""For how many seconds a page is heard without a gap before it is closed."""
# Nothing leaves this machine: the name is a name of it.
RESOLVE = f"--host-resolver-rules=MAP {NAME} 127.0.0.1"


def test_page_by_plain_http_explains_tls_and_offers_demo(
    server: Server, api: Api, playwright: Playwright, copter: Json
) -> None:
    """End to end because a browser is what withholds the place of a phone."""
    browser = launch(playwright, RESOLVE)
    page = open_phone_page(browser)
    sign_in(page, f"http://{NAME}:{server.http_port}/follow", api)
    explains = page.get_by_role("alert")
    expect(explains).to_contain_text("not encrypted")
    expect(explains).to_contain_text("./dronemap up --public")
    picture(page, "follow-plain-http")
    page.get_by_role("button", name="I am indoors: use a demo walk").tap()
    expect(page.get_by_role("note")).to_contain_text("A recorded walk stands for your phone")
    expect(page.get_by_role("button", name="Ask for a drone")).to_be_visible()
    picture(page, "follow-demo")
    browser.close()


@dataclass
class TlsServer:
    """A server that speaks TLS with a certificate of its own, and a copter that is ready."""

    server: Server
    api: Api
    door: str
    drone: Json


@pytest.fixture(scope="module")
def tls_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[TlsServer]:
    folder = tmp_path_factory.mktemp("machine")
    port = free_port()
    settings = make_certificate(folder) | {"DRONEMAP_PHONE_PORT": str(port)}
    server = Server(folder / "data", False, True, **settings)
    server.start()
    api = Api(server.address, server.local_key(), server.authority)
    address = f"udp://127.0.0.1:{server.udp_port}"
    arguments = ("--count", "1", "--speedup", "2", "--sysid", str(SYSTEM_ID))
    simulator = Simulator(folder / "sim.log", address, *arguments)
    try:
        drone = wait_for("the copter is ready", lambda: api.ready(SYSTEM_ID), 90)
        yield TlsServer(server, api, f"http://{NAME}:{port}/", drone)
    finally:
        simulator.stop()
        server.stop()


@pytest.fixture(scope="module")
def browser(
    tls_server: TlsServer, playwright: Playwright, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Browser]:
    """One that trusts the machine since somebody went through the steps of its page for phones."""
    home = tmp_path_factory.mktemp("home")
    stranger = launch(playwright, RESOLVE, home=home)
    page = open_phone_page(stranger)
    page.goto(tls_server.door)
    expect(page.get_by_role("heading", level=1)).to_contain_text("this phone first")
    picture(page, "follow-door")
    link = page.get_by_role("link", name=re.compile("follow$")).get_attribute("href")
    assert link == f"https://{NAME}:{tls_server.server.http_port}/follow"
    with page.expect_download() as download:
        page.get_by_role("link", name="Download the certificate").tap()
    certificate = home / download.value.suggested_filename
    download.value.save_as(certificate)
    fingerprint = fingerprint_of(certificate)
    expect(page.get_by_text(fingerprint)).to_be_visible()
    with pytest.raises(Error, match="ERR_CERT_AUTHORITY_INVALID"):
        page.goto(link)
    stranger.close()

    trust_certificate(home, certificate)
    trusting = launch(playwright, RESOLVE, home=home)
    yield trusting
    trusting.close()


def fingerprint_of(certificate: Path) -> str:
    digest = hashlib.sha256(certificate.read_bytes()).hexdigest().upper()
    return ":".join(digest[i : i + 2] for i in range(0, len(digest), 2))


def metres_away(tls_server: TlsServer, place: Point) -> float:
    position = tls_server.api.drone(tls_server.drone["id"])["position"]
    return place.metres_to(position["latitude"], position["longitude"])


def test_drone_follows_a_phone_over_tls(tls_server: TlsServer, browser: Browser) -> None:
    """End to end because a browser trusts the certificate, and tells where the phone is."""
    home = tls_server.drone["home"]
    page = open_phone_page(browser, beside(home, Walker.east, Walker.north))
    walker = Walker(page, home)
    sign_in(page, f"https://{NAME}:{tls_server.server.http_port}/follow", tls_server.api)
    assert page.evaluate("isSecureContext")

    expect(page.get_by_text("You are on the map, to 4 m.")).to_be_visible()
    page.get_by_role("button", name="Ask for a drone").tap()
    expect(page.get_by_role("alert").filter(has_text="The warehouse has no drone")).to_be_visible()
    page.get_by_role("combobox", name=re.compile("^Drone")).select_option(tls_server.drone["id"])
    picture(page, "follow-ask")
    page.get_by_role("button", name="Ask for a drone").tap()
    walker.wait_for_heading("Ready to start")
    expect(page.get_by_text(f"Why {tls_server.drone['name']}?")).to_be_visible()
    picture(page, "follow-ready")

    Touch().hold(page, page.get_by_role("button", name="Start", exact=True))
    walker.wait_for_heading("Taking off")
    picture(page, "follow-taking-off")
    walker.wait_for_heading("Following you", 60)

    def near() -> bool:
        walker.step(0.5)
        return metres_away(tls_server, walker.place) < 12

    wait_for("the drone has come", near, 60)
    begun = walker.north
    wait_for("it goes where the phone goes", lambda: near() and walker.north > begun + 15, 60)
    picture(page, "follow-following")

    page.context.set_offline(True)
    expect(page.get_by_role("heading", name="No network", exact=True)).to_be_visible()
    expect(page.get_by_text(re.compile("It flies home in .* s"))).to_be_visible()
    for name in ("Pause", "Stop and fly home"):
        expect(page.get_by_role("button", name=name, exact=True)).to_be_in_viewport(ratio=1)
    picture(page, "follow-cut-off")
    page.context.set_offline(False)
    expect(page.get_by_role("heading", name="No network", exact=True)).to_be_hidden()
    wait_for("the drone is near again", near, 60)

    check_reopened_page(tls_server, walker)

    page = walker.page
    page.get_by_role("button", name="Pause", exact=True).tap()
    walker.wait_for_heading("Paused")
    picture(page, "follow-paused")
    Touch().hold(page, page.get_by_role("button", name="Stop and fly home"))
    walker.wait_for_heading("Flying home")
    picture(page, "follow-returning")


def check_reopened_page(tls_server: TlsServer, walker: Walker) -> None:
    address = walker.page.url
    (follow,) = tls_server.api.get("/follows")["follows"]

    def seen() -> Json:
        found: Json = tls_server.api.get(f"/follows/{follow['id']}")
        return found

    def missed() -> str | None:
        note: str = seen()["note"] or ""
        return note if note.startswith("The phone") else None

    times_received = 0

    def is_received() -> bool:
        """A page that the cloud does not hear yet again is cut off when it is closed; and what it said by its
        connection of before counts for 2.5 s."""
        nonlocal times_received
        walker.step()
        times_received = times_received + 1 if seen()["now"]["reach"] == "speaks" else 0
        return times_received > STEADY / 0.1

    wait_for("the cloud hears the page", is_received, 30)
    walker.page.close()
    note = wait_for("the cloud knows that the page is closed", missed, 20)
    assert note.startswith("The phone's page was closed")
    assert seen()["state"] == "tracking"
    walker.page = walker.context.new_page()
    walker.page.goto(address)
    walker.wait_for_line("This page was closed for", "Now it follows you again.")
    picture(walker.page, "follow-back")

    def follows() -> bool:
        walker.step()
        now = seen()
        return bool(now["state"] == "tracking" and now["note"] is None)

    wait_for("it follows again", follows, 20)
