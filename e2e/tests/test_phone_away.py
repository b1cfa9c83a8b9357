"""A phone freezes, loses its network or its tab: shown apart on phone and station, while the drone holds."""

import re
import secrets
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Error, Page, Playwright, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.cuttable_proxy import CuttableProxy
from dronemap_e2e.flight import Point
from dronemap_e2e.message_recorder import MessageRecorder
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station, Touch, launch
from dronemap_e2e.waiting import rounds, wait_for
from dronemap_e2e.walker import Walker, beside, create_operator, open_phone_page, picture, sign_in

SYSTEM_ID = 78
PACE = 1.0
# It holds after two seconds, and brakes.
STANDS_AFTER = 4.0
STANDS_WITHIN = 2.0
NEAR = 12.0
FROZEN = 15.0
CUT = 30.0
# A page that opens on a busy machine takes long; the drone flies home after 60 s.
BACK_SECONDS = 45
SLEEPS = "The phone's page stands still: the screen is off, or something else is in front of it."
CUT_OFF = "The phone cannot be reached: it has no network."
CLOSED = "The phone's page was closed, or has crashed."
AGAIN = "The phone says again where it is."


@pytest.fixture
def drone(recorder: MessageRecorder, api: Api, tmp_path: Path) -> Iterator[Json]:
    """It lives as fast as the phone."""
    address = f"udp://127.0.0.1:{recorder.port}"
    started = Simulator(tmp_path / "sim.log", address, "--count", "1", "--sysid", str(SYSTEM_ID))
    yield wait_for("the copter is ready", lambda: api.ready(SYSTEM_ID), 90)
    started.stop()


@dataclass
class Network:
    """Between the phone and the cloud; the station has another one."""

    web: CuttableProxy
    stream: CuttableProxy

    @property
    def lines(self) -> tuple[CuttableProxy, CuttableProxy]:
        return self.web, self.stream


@pytest.fixture
def network(server: Server) -> Iterator[Network]:
    made = Network(CuttableProxy(server.http_port), CuttableProxy(server.stream_port))
    yield made
    for line in made.lines:
        line.close()


@pytest.fixture
def browser(server: Server, network: Network, playwright: Playwright) -> Iterator[Browser]:
    """A browser whose requests to localhost go through the network of the phone."""
    ways = {server.http_port: network.web.port, server.stream_port: network.stream.port}
    rules = ",".join(f"MAP localhost:{port} 127.0.0.1:{way}" for port, way in ways.items())
    started = launch(playwright, f"--host-resolver-rules={rules}")
    yield started
    started.close()


@dataclass
class PhoneTrial:
    """A person with a phone, a drone that follows, and somebody at the station who looks on."""

    api: Api
    recorder: MessageRecorder
    drone: Json
    walker: Walker
    station: Page
    follow: str = ""

    def seen(self) -> Json:
        return self.api.get(f"/follows/{self.follow}")

    def walk_until(self, what: str, condition: Callable[[], object], seconds: float = 60) -> None:
        def stepped() -> object:
            self.walker.step(PACE)
            return condition()

        wait_for(what, stepped, seconds, every=1)

    def is_near(self) -> bool:
        position = self.api.drone(self.drone["id"])["position"]
        return self.walker.place.metres_to(position["latitude"], position["longitude"]) < NEAR

    def wait_for_message(self, words: str, seconds: float = 20) -> None:
        """Waits until the cloud and the station show these words."""
        wait_for(f"told: {words}", lambda: (self.seen()["note"] or "").startswith(words), seconds)
        assert self.seen()["now"]["reach"] == {SLEEPS: "asleep", CUT_OFF: "cut", CLOSED: "gone"}[words]
        shelf = self.station.get_by_role("region", name="Follow me")
        expect(shelf).to_contain_text(words)
        expect(shelf).to_contain_text("stands still and waits for")
        expect(shelf).to_contain_text(re.compile(r"Silent for \d+ s; flies home in \d+ s"))

    def check_drone_stood(self, since: float) -> None:
        """Checks by the vehicle's own messages that it held its place from then on."""
        recorded = self.recorder.messages("GLOBAL_POSITION_INT", up=True, since=since + STANDS_AFTER)
        places = [Point(h.message.lat / 1e7, h.message.lon / 1e7, 0) for h in recorded]
        assert len(places) > 10
        strayed = max(places[0].metres_to(one.latitude, one.longitude) for one in places)
        print(f"it strayed {strayed:.2f} m in {recorded[-1].at - recorded[0].at:.0f} s")
        assert strayed < STANDS_WITHIN

    def check_following_again(self, words: str, name: str) -> None:
        """Checks that the page explains the gap, and that the drone follows again."""
        page = self.walker.page
        line = self.walker.wait_for_line(words, "Now it follows you again.", seconds=BACK_SECONDS)
        picture(page, name)
        print(" ".join(line.split()))
        assert re.search(r"stood and waited for \d+ s", line), line
        expect(page.get_by_role("heading", name="Following you")).to_be_visible()
        assert self.seen()["state"] == "tracking"
        begun = self.walker.north
        self.walk_until(
            "it follows again", lambda: self.walker.north > begun + 8 and self.is_near(), seconds=60
        )

    def opened_again(self) -> None:
        address = self.walker.page.url
        with suppress(Error):
            self.walker.page.close()
        self.walker.page = self.walker.context.new_page()
        self.walker.page.goto(address)


@pytest.fixture
def trial(
    server: Server, api: Api, recorder: MessageRecorder, drone: Json, browser: Browser
) -> Iterator[PhoneTrial]:
    page = open_phone_page(browser, beside(drone["home"], Walker.east, Walker.north))
    desk = open_page(browser, dark=True)
    Station(desk, Pointer()).sign_in(server.address, *create_operator(api), secrets.token_hex(10))
    desk.get_by_role("button", name=re.compile("^Follow me")).click()
    made = PhoneTrial(api, recorder, drone, Walker(page, drone["home"]), desk)
    sign_in(page, f"http://localhost:{server.http_port}/follow", api)
    page.get_by_role("button", name="Change that").tap()
    page.get_by_role("combobox", name=re.compile("^Drone")).select_option(drone["id"])
    page.get_by_role("button", name="Ask for a drone").tap()
    made.walker.wait_for_heading("Ready to start")
    (follow,) = [one for one in api.get("/follows")["follows"] if one["drone"] == drone["id"]]
    made.follow = follow["id"]
    Touch().hold(page, page.get_by_role("button", name="Start", exact=True))
    made.walker.wait_for_heading("Following you", 60)
    made.walk_until("the drone has come", made.is_near)
    yield made
    api.call("POST", f"/follows/{made.follow}/stop")


def check_frozen_page(trial: PhoneTrial) -> None:
    """Nothing of the page runs any more, as when the system puts it to sleep; its connection lives in another
    process. (A page in sight, as all pages of a browser without a window are, cannot be frozen by name.)"""
    page = trial.walker.context.new_cdp_session(trial.walker.page)
    page.send("Debugger.enable")
    began = time.monotonic()
    page.send("Debugger.pause")
    trial.wait_for_message(SLEEPS)
    picture(trial.station, "away-asleep-station")
    for _ in rounds(began + FROZEN, 0.5):
        assert trial.seen()["now"]["reach"] == "asleep"
    trial.check_drone_stood(began)
    page.send("Debugger.resume")
    page.detach()
    trial.check_following_again("This page was stopped for", "away-asleep-back")


def check_lost_network(trial: PhoneTrial, network: Network) -> None:
    page = trial.walker.page
    for line in network.lines:
        line.cut()
    began = time.monotonic()
    trial.walk_until("the cloud knows", lambda: trial.seen()["now"]["reach"] == "cut", 20)
    trial.wait_for_message(CUT_OFF)
    expect(page.get_by_role("heading", name="The cloud does not answer")).to_be_visible()
    expect(page.get_by_text("stands still in the air and waits")).to_be_visible()
    expect(page.get_by_text(re.compile(r"It flies home in \d+ s"))).to_be_visible()
    expect(page.get_by_text("Last known")).to_be_visible()
    picture(page, "away-cut")
    picture(trial.station, "away-cut-station")
    for _ in rounds(began + CUT, 1):
        trial.walker.step(PACE)
    trial.check_drone_stood(began)
    for line in network.lines:
        line.restore()
    trial.check_following_again("The cloud did not answer for", "away-cut-back")


def check_closed_tab(trial: PhoneTrial, how: Callable[[Page], object], name: str) -> None:
    began = time.monotonic()
    how(trial.walker.page)
    trial.wait_for_message(CLOSED)
    picture(trial.station, f"{name}-station")
    wait_for("it has stood for a while", lambda: time.monotonic() > began + STANDS_AFTER + 4, 20)
    trial.check_drone_stood(began)
    trial.opened_again()
    trial.check_following_again("This page was closed for", f"{name}-back")


@pytest.mark.soak
def test_drone_holds_while_phone_is_away_and_follows_again(trial: PhoneTrial, network: Network) -> None:
    check_frozen_page(trial)
    check_lost_network(trial, network)
    check_closed_tab(trial, Page.close, "away-closed")

    # A phone that is cut off may look asleep for a moment: what was said last before it was back counts.
    # A page also stands still by itself while it opens on a slow machine.
    messages = trial.seen()["told"]
    known = (SLEEPS, CUT_OFF, CLOSED, AGAIN)
    reasons = [each for one in messages for each in known if one["words"].startswith(each)]
    pairs = zip(reasons, reasons[1:], strict=False)
    ended = [before for before, after in pairs if after == AGAIN and before != AGAIN]
    others = [reason for reason in ended if reason != SLEEPS]
    assert SLEEPS in ended[: ended.index(CUT_OFF)] and others == [CUT_OFF, CLOSED], "\n".join(
        f"{one['at']} {one['words']}" for one in messages
    )
