"""A page over a line that carries nothing any more, and the stop that ends a flight at once."""

import os
import re
import secrets
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import DESK, PHONE, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.station import InputMethod, Keyboard, Pointer, Station, Touch
from dronemap_e2e.waiting import wait_for
from dronemap_e2e.walker import picture

from .conftest import SYSTEM_IDS

# Keeps when the page had the last word of the cloud, and how it first said that there is none.
WATCH = """(() => {
  window.lastHeard = 0;
  window.told = null;
  window.WebSocket = class extends WebSocket {
    constructor(...all) {
      super(...all);
      this.addEventListener('message', () => { window.lastHeard = performance.now(); });
    }
  };
  new MutationObserver(() => {
    const bar = [...document.querySelectorAll('[role=alert]')]
      .find((one) => one.textContent.includes('No connection to the cloud for'));
    if (bar && window.told === null) {
      window.told = { after: performance.now() - window.lastHeard, words: bar.textContent };
    }
  }).observe(document, { subtree: true, childList: true, characterData: true });
})()"""
TOLD_MILLISECONDS = 3_000
COMMANDS = ("Arm", "Disarm", "Take off", "Hold", "Return to launch", "Land", "Keep control")


@pytest.fixture
def hovering(killable_server: Server, tmp_path: Path) -> Iterator[tuple[Api, Json]]:
    system_id = next(SYSTEM_IDS)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{killable_server.udp_port}",
        *("--count", "1", "--sysid", str(system_id)),
        *QUICK_FLIGHT,
    )
    api = Api(killable_server.address, killable_server.local_key())
    drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)
    api.do(drone["id"], type="arm")
    api.do(drone["id"], type="takeOff", altitude=10)
    wait_for("it hovers", lambda: api.drone(drone["id"])["position"]["altitudeAboveHome"] > 9, 60)
    yield api, drone
    simulator.stop()


def supervisor(api: Api) -> tuple[str, str]:
    name, password = f"super-{secrets.token_hex(4)}", secrets.token_hex(10)
    made = api.call("POST", "/users", {"name": name, "password": password, "role": "supervisor"})
    assert made.status_code == 201, made.text
    return name, password


def pictures(page: Page, name: str) -> None:
    """At both sizes and in both themes, for people to look at."""
    if "DRONEMAP_E2E_SCREENSHOTS" not in os.environ:
        return
    for size, wide in ((DESK, "desk"), (PHONE, "phone")):
        page.set_viewport_size(size)
        for scheme in ("light", "dark"):
            page.emulate_media(color_scheme=scheme)
            page.wait_for_timeout(800)
            picture(page, f"{name}-{wide}-{scheme}")
    page.emulate_media(color_scheme="light")
    page.set_viewport_size(DESK)


def test_page_reports_cut_connection_within_three_seconds(
    killable_server: Server, browser: Browser, hovering: tuple[Api, Json]
) -> None:
    """End to end because a stopped server keeps its connections open: only a browser shows what it sees."""
    api, drone = hovering
    page = open_page(browser)
    page.add_init_script(WATCH)
    station = Station(page, Pointer())
    station.sign_in(killable_server.address, *supervisor(api), secrets.token_hex(10))
    station.choose(drone["name"])
    # Who flew it up has control for 30 s after that.
    expect(station.button("Take control")).to_be_visible(timeout=60_000)
    station.press("Take control")
    expect(station.button("Give back")).to_be_visible()
    expect(page.get_by_text("Connected")).to_be_visible()
    pictures(page, "line-up")

    os.kill(killable_server.pid, signal.SIGSTOP)
    try:
        expect(page.get_by_role("alert").filter(has_text="No connection to the cloud for")).to_be_visible()
        notice = page.evaluate("window.told")
        assert notice["after"] <= TOLD_MILLISECONDS, notice
        assert re.search(r"for [23] s", notice["words"]), "the age is counted from the last word of the cloud"
        expect(page.get_by_text("Connected")).to_have_count(0)
        expect(page.get_by_text(re.compile("these are the last values, .* ago"))).to_be_visible()
        expect(page.get_by_text(re.compile("^Offline · .* ago")).first).to_be_visible()
        expect(page.get_by_text("Offline: you may have lost control")).to_be_visible()
        for label in COMMANDS:
            for button in station.button(label).all():
                expect(button).to_have_attribute("aria-disabled", "true")
        pictures(page, "line-cut")
    finally:
        os.kill(killable_server.pid, signal.SIGCONT)
    expect(page.get_by_text("Connected")).to_be_visible()
    expect(page.get_by_text(re.compile("these are the last values"))).to_have_count(0)
    expect(station.button("Hold")).to_have_attribute("aria-disabled", "false")
    page.context.close()


@pytest.mark.parametrize("input_method", [Keyboard(), Touch()], ids=["keyboard", "touch"])
def test_emergency_stop_needs_two_holds(
    killable_server: Server, browser: Browser, hovering: tuple[Api, Json], input_method: InputMethod
) -> None:
    """End to end because holds are of real keys and fingers, and what follows is seen at the vehicle."""
    api, drone = hovering
    touch = isinstance(input_method, Touch)
    page = open_page(browser, PHONE if touch else DESK, touch=touch)
    station = Station(page, input_method)
    station.sign_in(killable_server.address, *supervisor(api), secrets.token_hex(10))
    station.choose(drone["name"])
    input_method.press(page, page.get_by_role("button", name=re.compile("^Emergency stop")).first)
    expect(page.get_by_text(f"{drone['name']} FALLS from where it is")).to_be_visible()
    picture(page, f"stop-{'phone' if touch else 'desk'}-light")
    stop = page.get_by_role("button", name="Emergency stop: motors off")
    # Who flew it up has control for 30 s after that.
    expect(stop).to_have_attribute("aria-disabled", "false", timeout=60_000)
    input_method.hold(page, stop)
    expect(page.get_by_text("Once more, within 3 s")).to_be_visible()
    assert api.drone(drone["id"])["armed"], "one hold sends nothing"
    input_method.hold(page, page.get_by_role("button", name="Hold again: the motors stop now"))
    wait_for("its motors stand still", lambda: not api.drone(drone["id"])["armed"], 30)
    expect(page.get_by_text("Emergency stop: Done")).to_be_visible()
    page.context.close()
