"""A person with a phone who wants to be followed, and the page on that phone."""

import math
import os
import secrets
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Browser, BrowserContext, Geolocation, Page, expect

from .api import Api, Json
from .flight import Point
from .screen import PHONE, open_page
from .waiting import wait_for

METRES_PER_DEGREE = 111_195
ACCURACY_METRES = 4


def create_operator(api: Api) -> tuple[str, str]:
    name, password = f"walker-{secrets.token_hex(3)}", secrets.token_hex(10)
    made = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert made.status_code == 201, made.text
    return name, password


def sign_in(page: Page, address: str, api: Api) -> None:
    name, password = create_operator(api)
    page.goto(address)
    page.get_by_label("User name").fill(name)
    page.get_by_label("Password", exact=True).fill(password)
    page.get_by_role("button", name="Sign in", exact=True).tap()
    page.get_by_label("New password").fill(secrets.token_hex(10))
    page.get_by_role("button", name="Save and continue").tap()
    expect(page.get_by_role("heading", name="A drone that follows you")).to_be_visible()


def open_phone_page(browser: Browser, at: Point | None = None, dark: bool = False) -> Page:
    """A page as big as a phone's, whose receiver says that it is there."""
    return open_page(
        browser,
        PHONE,
        touch=True,
        dark=dark,
        device_scale_factor=2,
        geolocation=None if at is None else _fix(at),
        permissions=["geolocation"] if at else [],
    )


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def beside(home: Json, east: float, north: float) -> Point:
    across = METRES_PER_DEGREE * math.cos(math.radians(home["latitude"]))
    return Point(home["latitude"] + north / METRES_PER_DEGREE, home["longitude"] + east / across, 0)


def _fix(at: Point) -> Geolocation:
    return {"latitude": at.latitude, "longitude": at.longitude, "accuracy": ACCURACY_METRES}


@dataclass
class Walker:
    """The person who carries the phone; metres from the drone's home."""

    page: Page
    home: Json
    east: float = 20
    north: float = 10

    @property
    def place(self) -> Point:
        return beside(self.home, self.east, self.north)

    @property
    def context(self) -> BrowserContext:
        return self.page.context

    def step(self, north: float = 0) -> None:
        """A receiver speaks once in a while also of who stands still."""
        self.north += north
        self.context.set_geolocation(_fix(self.place))

    def wait_for_heading(self, words: str, seconds: float = 20) -> None:
        heading = self.page.get_by_role("heading", level=1)

        def reads() -> bool:
            self.step()
            return heading.inner_text().strip() == words

        wait_for(f"the page says {words}", reads, seconds)

    def wait_for_line(self, *words: str, seconds: float = 30) -> str:
        """Text of one line of the page, once it has these words."""
        line = self.page.get_by_role("listitem").filter(has_text=words[0])

        def read() -> str | None:
            self.step()
            text = line.inner_text() if line.is_visible() else ""
            return text if all(one in text for one in words) else None

        try:
            return wait_for(f"the page says {words[0]}", read, seconds)
        except AssertionError as missing:
            raise AssertionError(f"{missing}; it says: {self.page.inner_text('body')}") from missing
