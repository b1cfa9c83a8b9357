"""A phone freezes, loses its network or its tab: told apart on phone and station, while the drone stands."""

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
from dronemap_e2e.flight import Point
from dronemap_e2e.line import Line
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station, Touch, launch
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import rounds, wait_for
from dronemap_e2e.walker import Walker, a_person, beside, phone, picture, sign_in

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
def drone(tap: Tap, api: Api, tmp_path: Path) -> Iterator[Json]:
    """It lives as fast as the phone."""
    address = f"udp://127.0.0.1:{tap.port}"
    started = Simulator(tmp_path / "sim.log", address, "--count", "1", "--sysid", str(SYSTEM_ID))
    yield wait_for("the copter is ready", lambda: api.ready(SYSTEM_ID), 90)
    started.stop()


@dataclass
class Network:
    """Between the phone and the cloud; the station has another one."""

    web: Line
    stream: Line

    @property
    def lines(self) -> tuple[Line, Line]:
        return self.web, self.stream


@pytest.fixture
def network(server: Server) -> Iterator[Network]:
    made = Network(Line(server.http_port), Line(server.stream_port))
    yield made
    for line in made.lines:
        line.close()


@pytest.fixture
def browser(server: Server, network: Network, playwright: Playwright) -> Iterator[Browser]:
    """What calls itself localhost goes through the network of the phone."""
    ways = {server.http_port: network.web.port, server.stream_port: network.stream.port}
    rules = ",".join(f"MAP localhost:{port} 127.0.0.1:{way}" for port, way in ways.items())
    started = launch(playwright, f"--host-resolver-rules={rules}")
    yield started
    started.close()


@dataclass
class Trial:
    """A person with a phone, a drone that follows, and somebody at the station who looks on."""

    api: Api
    tap: Tap
    drone: Json
    walker: Walker
    station: Page
    follow: str = ""

    def seen(self) -> Json:
        return self.api.get(f"/follows/{self.follow}")

    def walks_until(self, what: str, condition: Callable[[], object], seconds: float = 60) -> None:
        def stepped() -> object:
            self.walker.step(PACE)
            return condition()

        wait_for(what, stepped, seconds, every=1)

    def is_near(self) -> bool:
        position = self.api.drone(self.drone["id"])["position"]
        return self.walker.place.metres_to(position["latitude"], position["longitude"]) < NEAR

    def told_within(self, words: str, seconds: float = 20) -> None:
        """The cloud says so, and the station."""
        wait_for(f"told: {words}", lambda: (self.seen()["note"] or "").startswith(words), seconds)
        assert self.seen()["now"]["reach"] == {SLEEPS: "asleep", CUT_OFF: "cut", CLOSED: "gone"}[words]
        shelf = self.station.get_by_role("region", name="Follow me")
        expect(shelf).to_contain_text(words)
        expect(shelf).to_contain_text("stands still and waits for")
        expect(shelf).to_contain_text(re.compile(r"Silent for \d+ s; flies home in \d+ s"))

    def stood(self, since: float) -> None:
        """From then on, as the vehicle itself said."""
        heard = self.tap.heard("GLOBAL_POSITION_INT", up=True, since=since + STANDS_AFTER)
        places = [Point(h.message.lat / 1e7, h.message.lon / 1e7, 0) for h in heard]
        assert len(places) > 10
        strayed = max(places[0].metres_to(one.latitude, one.longitude) for one in places)
        print(f"it strayed {strayed:.2f} m in {heard[-1].at - heard[0].at:.0f} s")
        assert strayed < STANDS_WITHIN

    def is_back(self, words: str, name: str) -> None:
        """The page says what was, and the drone comes along again."""
        page = self.walker.page
        said = self.walker.reads(words, "Now it follows you again.", seconds=BACK_SECONDS)
        picture(page, name)
        print(" ".join(said.split()))
        assert re.search(r"stood and waited for \d+ s", said), said
        expect(page.get_by_role("heading", name="Following you")).to_be_visible()
        assert self.seen()["state"] == "tracking"
        begun = self.walker.north
        self.walks_until(
            "it follows again", lambda: self.walker.north > begun + 8 and self.is_near(), seconds=60
        )

    def opened_again(self) -> None:
        address = self.walker.page.url
        with suppress(Error):
            self.walker.page.close()
        self.walker.page = self.walker.context.new_page()
        self.walker.page.goto(address)


@pytest.fixture
def trial(server: Server, api: Api, tap: Tap, drone: Json, browser: Browser) -> Iterator[Trial]:
    page = phone(browser, beside(drone["home"], Walker.east, Walker.north))
    desk = open_page(browser, dark=True)
    Station(desk, Pointer()).sign_in(server.address, *a_person(api), secrets.token_hex(10))
    desk.get_by_role("button", name=re.compile("^Follow me")).click()
    made = Trial(api, tap, drone, Walker(page, drone["home"]), desk)
    sign_in(page, f"http://localhost:{server.http_port}/follow", api)
    page.get_by_role("button", name="Change that").tap()
    page.get_by_role("combobox", name=re.compile("^Drone")).select_option(drone["id"])
    page.get_by_role("button", name="Ask for a drone").tap()
    made.walker.stands_until("Ready to start")
    (follow,) = [one for one in api.get("/follows")["follows"] if one["drone"] == drone["id"]]
    made.follow = follow["id"]
    Touch().hold(page, page.get_by_role("button", name="Start", exact=True))
    made.walker.stands_until("Following you", 60)
    made.walks_until("the drone has come", made.is_near)
    yield made
    api.call("POST", f"/follows/{made.follow}/stop")


def freezes(trial: Trial) -> None:
    """Nothing of the page runs any more, as when the system puts it to sleep; its connection lives in another
    process. (A page in sight, as all pages of a browser without a window are, cannot be frozen by name.)"""
    page = trial.walker.context.new_cdp_session(trial.walker.page)
    page.send("Debugger.enable")
    began = time.monotonic()
    page.send("Debugger.pause")
    trial.told_within(SLEEPS)
    picture(trial.station, "away-asleep-station")
    for _ in rounds(began + FROZEN, 0.5):
        assert trial.seen()["now"]["reach"] == "asleep"
    trial.stood(began)
    page.send("Debugger.resume")
    page.detach()
    trial.is_back("This page was stopped for", "away-asleep-back")


def is_cut_off(trial: Trial, network: Network) -> None:
    page = trial.walker.page
    for line in network.lines:
        line.cut()
    began = time.monotonic()
    trial.walks_until("the cloud knows", lambda: trial.seen()["now"]["reach"] == "cut", 20)
    trial.told_within(CUT_OFF)
    expect(page.get_by_role("heading", name="The cloud does not answer")).to_be_visible()
    expect(page.get_by_text("stands still in the air and waits")).to_be_visible()
    expect(page.get_by_text(re.compile(r"It flies home in \d+ s"))).to_be_visible()
    expect(page.get_by_text("Last known")).to_be_visible()
    picture(page, "away-cut")
    picture(trial.station, "away-cut-station")
    for _ in rounds(began + CUT, 1):
        trial.walker.step(PACE)
    trial.stood(began)
    for line in network.lines:
        line.mend()
    trial.is_back("The cloud did not answer for", "away-cut-back")


def loses_its_tab(trial: Trial, how: Callable[[Page], object], name: str) -> None:
    began = time.monotonic()
    how(trial.walker.page)
    trial.told_within(CLOSED)
    picture(trial.station, f"{name}-station")
    wait_for("it has stood for a while", lambda: time.monotonic() > began + STANDS_AFTER + 4, 20)
    trial.stood(began)
    trial.opened_again()
    trial.is_back("This page was closed for", f"{name}-back")


@pytest.mark.soak
def test_the_drone_stands_while_its_phone_is_away_and_goes_on_when_it_is_back(
    trial: Trial, network: Network
) -> None:
    freezes(trial)
    is_cut_off(trial, network)
    loses_its_tab(trial, Page.close, "away-closed")

    # A phone that is cut off may look asleep for a moment: what was said last before it was back counts.
    # A page also stands still by itself while it opens on a slow machine.
    told = trial.seen()["told"]
    known = (SLEEPS, CUT_OFF, CLOSED, AGAIN)
    reasons = [each for one in told for each in known if one["words"].startswith(each)]
    pairs = zip(reasons, reasons[1:], strict=False)
    ended = [before for before, after in pairs if after == AGAIN and before != AGAIN]
    others = [reason for reason in ended if reason != SLEEPS]
    assert SLEEPS in ended[: ended.index(CUT_OFF)] and others == [CUT_OFF, CLOSED], "\n".join(
        f"{one['at']} {one['words']}" for one in told
    )
