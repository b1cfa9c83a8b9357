"""The ground station as hands use it: by pointer, by touch, by keyboard; found by visible text alone."""

import os
import re
import shutil
from pathlib import Path
from typing import Protocol

from playwright.sync_api import Browser, Locator, Page, Playwright, expect

# The page wants 800 between its events, and the time runs only when it has taken the first of them.
HOLD_MILLISECONDS = 900
# A machine that does much else at the same time answers late.
PATIENCE_MILLISECONDS = 20_000
CHROMIUM_ARGUMENTS = [
    "--no-sandbox",
    # There is no graphics card: software stands for it where a map is drawn, and nowhere else.
    "--disable-gpu",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def launch(playwright: Playwright, *arguments: str, home: Path | None = None) -> Browser:
    """`home`: where the browser keeps whom it trusts, instead of the user's own."""
    chromium = os.environ.get("DRONEMAP_CHROMIUM") or shutil.which("chromium")
    assert chromium, "chromium is missing: ./dronemap test installs it"
    expect.set_options(timeout=PATIENCE_MILLISECONDS)
    return playwright.chromium.launch(
        executable_path=chromium,
        args=[*CHROMIUM_ARGUMENTS, *arguments],
        env=None if home is None else {**os.environ, "HOME": str(home), "XDG_DATA_HOME": str(home / "data")},
    )


class InputMethod(Protocol):
    """Presses, holds and points as a person does."""

    def press(self, page: Page, target: Locator) -> None: ...

    def hold(self, page: Page, target: Locator) -> None: ...

    def tap_map(self, page: Page, x: float, y: float) -> None: ...


class Pointer:
    def press(self, page: Page, target: Locator) -> None:
        target.click()

    def hold(self, page: Page, target: Locator) -> None:
        # Comes to rest on it, also when what is above it has just changed.
        target.hover()
        page.mouse.down()
        page.wait_for_timeout(HOLD_MILLISECONDS)
        page.mouse.up()

    def tap_map(self, page: Page, x: float, y: float) -> None:
        page.mouse.click(x, y)


class Touch:
    def press(self, page: Page, target: Locator) -> None:
        target.tap()

    def hold(self, page: Page, target: Locator) -> None:
        target.hover(trial=True)
        box = target.bounding_box()
        assert box
        point = {"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2}
        devices = page.context.new_cdp_session(page)
        devices.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [point]})
        page.wait_for_timeout(HOLD_MILLISECONDS)
        devices.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        devices.detach()

    def tap_map(self, page: Page, x: float, y: float) -> None:
        page.touchscreen.tap(x, y)


class Keyboard:
    """Tab to the control, Enter on it; the map is not needed, coordinates are typed."""

    def press(self, page: Page, target: Locator) -> None:
        self._reach(page, target)
        page.keyboard.press("Enter")

    def hold(self, page: Page, target: Locator) -> None:
        self._reach(page, target)
        page.keyboard.down("Enter")
        page.wait_for_timeout(HOLD_MILLISECONDS)
        page.keyboard.up("Enter")

    def tap_map(self, page: Page, x: float, y: float) -> None:
        raise AssertionError("a keyboard does not point at maps")

    def _reach(self, page: Page, target: Locator) -> None:
        expect(target).to_be_visible()
        for _ in range(200):
            if target.evaluate("element => element === document.activeElement"):
                return
            page.keyboard.press("Tab")
        raise AssertionError(f"Tab never reaches {target}")


class Station:
    """One open page."""

    def __init__(self, page: Page, input_method: InputMethod) -> None:
        self.page = page
        self.input_method = input_method

    def sign_in(self, address: str, name: str, password: str, new_password: str) -> None:
        self.page.goto(address)
        self.page.get_by_label("User name").fill(name)
        self.page.get_by_label("Password", exact=True).fill(password)
        self.press("Sign in")
        choose = self.page.get_by_label("New password")
        fleet = self.page.get_by_text(re.compile("Disarmed|Armed")).first
        # A machine that starts other servers meanwhile takes its time.
        expect(choose.or_(fleet)).to_be_visible(timeout=20_000)
        if choose.is_visible():
            choose.fill(new_password)
            self.press("Save and continue")

    def choose(self, drone: str) -> None:
        self.input_method.press(self.page, self.page.get_by_role("button").filter(has_text=drone).first)
        expect(self.button("Arm")).to_be_visible()

    def button(self, label: str) -> Locator:
        return self.page.get_by_role("button", name=label, exact=True)

    def press(self, label: str) -> None:
        expect(self.button(label)).not_to_have_attribute("aria-disabled", "true")
        self.input_method.press(self.page, self.button(label))

    def hold(self, label: str) -> None:
        expect(self.button(label)).to_have_attribute("aria-disabled", "false")
        self.input_method.hold(self.page, self.button(label))

    def shows(self, text: str, seconds: float = 30) -> None:
        """Expects that text to become visible."""
        expect(self.page.get_by_text(text).first).to_be_visible(timeout=seconds * 1000)
