"""The page of the PHP SOAP proxy as hands use it, found by what is read on it."""

import os
import re
import secrets
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from playwright.sync_api import Browser, ConsoleMessage, Locator, Page, ViewportSize, expect

from .api import Api
from .flight import Point
from .php_proxy import PhpProxy
from .screen import open_page
from .server import Server
from .station import InputMethod, Touch

WIDE: ViewportSize = {"width": 1280, "height": 800}


class Pilot(NamedTuple):
    """An operator with a password that nobody else has seen."""

    name: str
    password: str
    api: Api


def new_pilot(server: Server, api: Api) -> Pilot:
    name, first, own = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    made = api.call("POST", "/users", {"name": name, "password": first, "role": "operator"})
    assert made.status_code == 201, made.text
    session = Api(server.address)
    assert session.call("POST", "/session", {"name": name, "password": first}).ok
    assert session.call("POST", "/session/password", {"current": first, "next": own}).status_code == 204
    return Pilot(name, own, session)


class Spot(NamedTuple):
    """A place on the screen."""

    x: float
    y: float


class PhpPage:
    """One open page."""

    def __init__(self, page: Page, input_method: InputMethod) -> None:
        self.page = page
        self.input_method = input_method

    def open(self, proxy: PhpProxy) -> None:
        self.page.goto(f"{proxy.address}/")

    def sign_in(self, name: str, password: str) -> None:
        self.page.get_by_label("User name").fill(name)
        self.page.get_by_label("Password", exact=True).fill(password)
        self.press("Sign in")

    def sign_in_by_key(self, key: str) -> None:
        self.page.get_by_role("radio", name="Access key").check()
        self.page.get_by_role("textbox", name="Access key").fill(key)
        self.press("Sign in")

    def button(self, label: str) -> Locator:
        return self.page.get_by_role("button", name=label, exact=True)

    def press(self, label: str) -> None:
        expect(self.button(label)).not_to_have_attribute("aria-disabled", "true")
        self.input_method.press(self.page, self.button(label))

    def hold(self, label: str) -> None:
        expect(self.button(label)).to_have_attribute("aria-disabled", "false")
        self.input_method.hold(self.page, self.button(label))

    def is_off(self, label: str, reason: str) -> None:
        expect(self.button(label)).to_have_attribute("aria-disabled", "true")
        expect(self.button(label)).to_contain_text(reason)

    def choose(self, drone: str) -> None:
        line = self.page.get_by_role("button", name=re.compile("Change|Close"))
        listed = self.page.get_by_role("listitem").get_by_role("button")
        expect(line.or_(listed).first).to_be_visible()
        # On a phone the list is folded to one line.
        if line.is_visible():
            self.input_method.press(self.page, line)
        named = listed.filter(has_text=re.compile(rf"{re.escape(drone)}\s"))
        self.input_method.press(self.page, named.first)
        expect(self.page.get_by_role("heading", name=drone, exact=True)).to_be_visible()

    def tool(self, name: str) -> None:
        """What a click on the map does."""
        self.page.get_by_role("radio", name=name).check()

    def says(self, text: str | re.Pattern[str], seconds: float = 30) -> None:
        """Expects it as what became of the newest command."""
        expect(self.outcome).to_contain_text(text, timeout=seconds * 1000)

    @property
    def outcome(self) -> Locator:
        return self.page.locator("#outcome")

    @property
    def alarm_button(self) -> Locator:
        """Takes control that has ended in the air."""
        return self.page.get_by_role("contentinfo").locator("#alarm-take")

    @property
    def target_mark(self) -> Locator:
        """Where the drone flies to, on the map."""
        return self.map.locator(".target")

    @property
    def map(self) -> Locator:
        return self.page.get_by_role("application")

    def mark(self, drone: str) -> Spot:
        """Where on the screen the map draws that drone (by its id)."""
        self.map.scroll_into_view_if_needed()
        return self.centre(f'[data-drone="{drone}"] .ring')

    def centre(self, mark: str) -> Spot:
        """Of the last such mark on the map (by CSS), on the screen."""
        # After what was asked for is drawn, and at one moment: the map is drawn anew while one looks.
        x, y = self.page.evaluate(
            """async (mark) => {
                 for (const _ of [1, 2]) await new Promise((drawn) => requestAnimationFrame(drawn));
                 const { x, y, width, height } =
                   [...document.querySelectorAll(mark)].at(-1).getBoundingClientRect();
                 return [x + width / 2, y + height / 2];
               }""",
            mark,
        )
        return Spot(x, y)

    def inside_map(self, drone: str) -> Spot:
        """Where that drone is on the map, however the page is scrolled."""
        x, y = self.page.evaluate(
            """(drone) => {
                 const mark = document.querySelector(`[data-drone="${drone}"] .ring`).getBoundingClientRect();
                 const map = document.getElementById('map').getBoundingClientRect();
                 return [Math.round(mark.x - map.x), Math.round(mark.y - map.y)];
               }""",
            drone,
        )
        return Spot(x, y)

    def tap(self, spot: Spot) -> None:
        self.input_method.tap_map(self.page, spot.x, spot.y)

    def swipe(self, start: Spot, end: Spot) -> None:
        """One finger from there to there."""
        devices = self.page.context.new_cdp_session(self.page)
        for step in range(6):
            x, y = (a + (b - a) * step / 5 for a, b in zip(start, end, strict=True))
            kind = "touchMove" if step else "touchStart"
            devices.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
        devices.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        devices.detach()

    def target(self) -> Point:
        """The place that it asks for a confirmation of."""
        latitude, longitude = self.page.get_by_label("Fly to (latitude, longitude)").input_value().split(",")
        height = self.page.get_by_label("Height above home (m)").input_value()
        return Point(float(latitude), float(longitude), float(height))

    def waypoints(self) -> list[Point]:
        """The draft, as its list shows it."""
        rows = self.page.locator("#waypoints li").all()
        return [self._waypoint(row) for row in rows]

    def _waypoint(self, row: Locator) -> Point:
        latitude, longitude = row.get_by_label("latitude, longitude").input_value().split(",")
        height = row.get_by_label("height in metres").input_value()
        return Point(float(latitude), float(longitude), float(height))

    def click_waypoints(self, drone: str) -> None:
        """Three of them, 8 m high, north-east of that drone."""
        self.tool("Waypoints")
        self.page.get_by_label("Height of new waypoints (m)").fill("8")
        mark = self.mark(drone)
        for number, (across, up) in enumerate(((0, 70), (60, 70), (60, 20)), 1):
            self.tap(Spot(mark.x + across, mark.y - up))
            expect(self.page.locator("#waypoints li")).to_have_count(number)

    def picture(self, name: str) -> None:
        """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
        folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
        if folder:
            Path(folder).mkdir(parents=True, exist_ok=True)
            self.page.screenshot(path=Path(folder) / f"php-{name}.png")


OpenPage = Callable[..., PhpPage]


class PhpPages:
    """Opens pages, each in a browser context of its own, and keeps what goes wrong in them."""

    def __init__(self, browser: Browser) -> None:
        self._browser = browser
        self._pages: list[Page] = []
        self.faults: list[str] = []

    def open(
        self, proxy: PhpProxy, method: InputMethod, size: ViewportSize = WIDE, dark: bool = False
    ) -> PhpPage:
        page = open_page(self._browser, size, isinstance(method, Touch), dark)
        self._pages.append(page)
        page.on("pageerror", lambda error: self.faults.append(str(error)))
        page.on("console", self._note)
        opened = PhpPage(page, method)
        opened.open(proxy)
        return opened

    def close(self) -> None:
        for page in self._pages:
            page.context.close()

    def _note(self, said: ConsoleMessage) -> None:
        # What the browser says of the page's Content-Security-Policy.
        if "Policy" in said.text:
            self.faults.append(said.text)
