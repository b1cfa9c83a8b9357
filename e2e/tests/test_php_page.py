"""A person flies by the page of the PHP SOAP proxy; judged by the vehicle's messages and by REST."""

import json
import os
import re
import secrets
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
import requests
from playwright.sync_api import Browser, Route, ViewportSize, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.cuttable_proxy import CuttableProxy
from dronemap_e2e.flight import Point, judge
from dronemap_e2e.ground_station import new_user
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.peer import Peer
from dronemap_e2e.php_page import PhpPage, Spot
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.screen import PHONE, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import InputMethod, Keyboard, Pointer, Touch
from dronemap_e2e.waiting import throughout, wait_for

WIDE: ViewportSize = {"width": 1280, "height": 800}
UNKNOWN = "Not known whether it was carried out"
Open = Callable[..., PhpPage]


class Pilot(NamedTuple):
    """An operator with a password that nobody else has seen."""

    name: str
    password: str
    api: Api


@pytest.fixture(scope="module")
def pilot(server: Server, api: Api) -> Pilot:
    name, first, own = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    made = api.call("POST", "/users", {"name": name, "password": first, "role": "operator"})
    assert made.status_code == 201, made.text
    session = Api(server.address)
    assert session.call("POST", "/session", {"name": name, "password": first}).ok
    assert session.call("POST", "/session/password", {"current": first, "next": own}).status_code == 204
    return Pilot(name, own, session)


@pytest.fixture(scope="module")
def proxy(server: Server, tmp_path_factory: pytest.TempPathFactory) -> Iterator[PhpProxy]:
    started = PhpProxy(server.address, tmp_path_factory.mktemp("php"))
    started.start()
    yield started
    started.stop()


@pytest.fixture
def opened(browser: Browser) -> Iterator[Open]:
    pages: list[PhpPage] = []

    def make(proxy: PhpProxy, method: InputMethod, size: ViewportSize = WIDE, dark: bool = False) -> PhpPage:
        page = PhpPage(open_page(browser, size, isinstance(method, Touch), dark), method)
        pages.append(page)
        page.page.on("pageerror", lambda error: faults.append(str(error)))
        page.page.on("console", lambda said: faults.append(said.text) if "Policy" in said.text else None)
        page.open(proxy)
        return page

    faults: list[str] = []
    yield make
    for page in pages:
        page.page.context.close()
    assert faults == [], "the page has faults of its own"


def picture(page: PhpPage, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.page.screenshot(path=Path(folder) / f"php-{name}.png")


def on_board(api: Api, drone: Json) -> list[Point]:
    """The waypoints of the mission that the drone has, as the server knows it from the vehicle."""
    items = api.drone(drone["id"])["mission"]["items"] or []
    return [
        Point(item["latitude"], item["longitude"], item["altitude"])
        for item in items
        if item["type"] == "waypoint"
    ]


def are_same(some: list[Point], others: list[Point]) -> bool:
    return len(some) == len(others) and all(
        one.metres_to(other.latitude, other.longitude) < 0.3 and abs(one.altitude - other.altitude) < 0.1
        for one, other in zip(some, others, strict=True)
    )


def height(api: Api, drone: Json) -> float:
    above: float = api.drone(drone["id"])["position"]["altitudeAboveHome"]
    return above


def away(api: Api, drone: Json, point: Point) -> float:
    position = api.drone(drone["id"])["position"]
    return point.metres_to(position["latitude"], position["longitude"])


def take_off(page: PhpPage, api: Api, drone: Json, metres: int) -> None:
    page.hold("Arm")
    page.says("Arm. Succeeded.")
    assert api.drone(drone["id"])["armed"]
    page.page.get_by_label("Take-off height (m)").fill(str(metres))
    page.hold("Take off")
    page.says(f"Take off to {metres} m. Succeeded")
    wait_for("it has climbed", lambda: height(api, drone) > metres - 1, 60)


def click_waypoints(page: PhpPage, drone: Json) -> None:
    page.tool("Waypoints")
    page.page.get_by_label("Height of new waypoints (m)").fill("8")
    mark = page.mark(drone["id"])
    for number, (across, up) in enumerate(((0, 70), (60, 70), (60, 20)), 1):
        page.tap(Spot(mark.x + across, mark.y - up))
        expect(page.page.locator("#waypoints li")).to_have_count(number)


def test_a_person_flies_a_mission_of_clicks(
    proxy: PhpProxy, opened: Open, pilot: Pilot, api: Api, wire: VehicleMessages, copter: Json
) -> None:
    """End to end because hands fly it in a browser, by PHP and SOAP, and the judge sees only the wire."""
    page = opened(proxy, Pointer())
    page.sign_in(pilot.name, pilot.password)
    page.choose(copter["name"])
    take_off(page, api, copter, 8)

    page.tool("Fly to")
    mark = page.mark(copter["id"])
    page.tap(mark)
    assert away(api, copter, page.target()) < 3, "a click means another place than the one drawn there"
    page.tap(Spot(mark.x, mark.y - 60))
    target = page.target()
    assert target.latitude > copter["home"]["latitude"]
    assert away(api, copter, target) > 10
    page.hold("Fly there")
    page.says(re.compile("Fly to .* Succeeded"))
    wait_for("it is where it was clicked", lambda: away(api, copter, target) < 2, 60)

    click_waypoints(page, copter)
    drawn = page.waypoints()
    picture(page, "planned")
    page.press("Save to drone")
    page.says("Save the mission of 3 waypoints. Succeeded.")
    assert are_same(on_board(api, copter), drawn)
    expect(page.page.get_by_text("Saved on the drone")).to_be_visible()

    page.page.reload()
    expect(page.page.get_by_text("Saved on the drone")).to_be_visible()
    page.press("Clear the draft")
    assert page.waypoints() == []
    page.press("Load from drone")
    assert are_same(page.waypoints(), drawn)

    page.hold("Start mission")
    page.says("Start mission. Succeeded")
    wait_for("it has flown the mission", lambda: len(api.drone(copter["id"])["mission"]["reached"]) >= 4, 120)
    picture(page, "flown")
    page.press("Return")
    page.says("Return to launch. Succeeded")
    wait_for("it landed and disarmed", lambda: api.drone(copter["id"])["armed"] is False, 120)
    expect(page.page.get_by_text("On the ground", exact=True).last).to_be_visible()
    judge(wire, drawn, 8)


def test_a_phone_flies_and_lands(proxy: PhpProxy, opened: Open, pilot: Pilot, api: Api, copter: Json) -> None:
    """End to end because fingers hold and tap on a small screen."""
    page = opened(proxy, Touch(), PHONE, dark=True)
    page.sign_in(pilot.name, pilot.password)
    page.choose(copter["name"])
    page.press("Arm")
    page.says("Nothing was sent: hold “Arm”")
    assert api.drone(copter["id"])["armed"] is False
    take_off(page, api, copter, 6)

    page.tool("Fly to")
    page.tap(page.mark(copter["id"]))
    page.page.get_by_label("Fly to (latitude, longitude)").fill("0.5, 0.5")
    page.page.get_by_label("Height above home (m)").fill("6")
    page.hold("Fly there")
    page.says(re.compile("Refused by the server: .* km from where it is"))

    click_waypoints(page, copter)
    drawn = page.waypoints()
    page.press("Save to drone")
    page.says("Succeeded")
    assert are_same(on_board(api, copter), drawn)
    picture(page, "phone")
    page.press("Hold")
    page.says("Hold. Succeeded.")
    page.press("Land")
    page.says("Land. Succeeded")
    wait_for("it landed and disarmed", lambda: api.drone(copter["id"])["armed"] is False, 120)


def test_page_shows_refusal_of_the_vehicle(
    server: Server, proxy: PhpProxy, opened: Open, pilot: Pilot, api: Api
) -> None:
    """End to end because a browser shows what a vehicle of another maker's program says."""
    sentence = f"PreArm: {secrets.token_hex(6)} not healthy"

    def deny(peer: Peer, message: object) -> None:
        peer.send_text(sentence)
        peer.acknowledge(message, 4)

    peer = Peer(server.udp_port, system_id=203, handlers={"COMMAND_LONG": deny})
    try:
        listed = lambda: next((d for d in api.drones() if d["link"]["port"] == peer.port), None)  # noqa: E731
        drone = wait_for("listed", listed)
        page = opened(proxy, Keyboard())
        page.sign_in(pilot.name, pilot.password)
        page.choose(drone["name"])
        page.hold("Arm")
        page.says(f"Arm. Refused by the drone: {sentence}")
        peer.silent = True
        expect(page.page.get_by_text(re.compile("^Lost: not heard for")).first).to_be_visible(timeout=60_000)
    finally:
        peer.close()


def test_lost_answer_is_shown_as_not_known_and_then_cleared_up(
    proxy: PhpProxy, opened: Open, pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because the connection of a browser breaks under a command."""
    page = opened(proxy, Keyboard())
    page.sign_in_by_key(pilot.api.new_key("page", "operator"))
    page.choose(copter["name"])

    def lose_answer(route: Route) -> None:
        route.fetch()
        route.abort()

    page.page.route("**/proxy.php?operation=arm", lose_answer)
    page.page.route("**/proxy.php?operation=getCommand", lambda route: route.abort())
    page.hold("Arm")
    page.says(UNKNOWN)
    page.says("Look at the drone before you press again")
    wait_for("the vehicle is armed", lambda: api.drone(copter["id"])["armed"])
    page.page.unroute("**/proxy.php?operation=getCommand")
    page.says("Arm. Succeeded.")

    page.page.route("**/proxy.php?operation=disarm", lambda route: route.abort())
    page.hold("Disarm")
    page.says(UNKNOWN)
    page.says("Not carried out: it did not reach the server.")
    assert api.drone(copter["id"])["armed"]
    page.page.unroute("**/proxy.php?operation=disarm")
    page.hold("Disarm")
    page.says("Disarm. Succeeded.")
    given = api.get(f"/drones/{copter['id']}/commands")["commands"]
    assert sorted(one["type"] for one in given if one["face"] != "rule") == ["arm", "disarm"]


def test_control_is_kept_while_the_page_is_open(
    proxy: PhpProxy, opened: Open, pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because a browser keeps it by a timer of its own, and stops when its page is closed."""
    page = opened(proxy, Pointer())
    page.sign_in(pilot.name, pilot.password)
    page.choose(copter["name"])
    page.press("Take control")
    expect(page.page.get_by_text("You have control while this page is open and in sight.")).to_be_visible()

    def held() -> bool:
        control = api.drone(copter["id"])["control"]
        return bool(control["explicit"]) and control["holder"] == pilot.name

    throughout("its pilot has control", held, 8)
    page.page.goto("about:blank")
    wait_for("control has ended", lambda: not held(), 20)


def test_line_to_the_server_that_is_cut(
    server: Server, opened: Open, pilot: Pilot, api: Api, copter: Json, tmp_path: Path
) -> None:
    """End to end because a line is cut between PHP and the server."""
    line = CuttableProxy(server.http_port)
    proxy = PhpProxy(f"http://127.0.0.1:{line.port}", tmp_path, DRONEMAP_PHP_PATIENCE="2")
    proxy.start()
    try:
        page = opened(proxy, Pointer())
        page.sign_in_by_key(pilot.api.new_key("cut", "operator"))
        page.choose(copter["name"])
        expect(page.button("Arm")).to_have_attribute("aria-disabled", "false")
        line.cut()
        expect(page.page.get_by_role("alert").filter(has_text="No connection to the drones.")).to_be_visible()
        expect(page.page.get_by_text(re.compile(r"^What is shown is \d+ s old"))).to_be_visible()
        expect(page.button("Arm")).to_have_attribute("aria-disabled", "true")
        picture(page, "cut")
        line.restore()
        expect(page.page.get_by_text("● Connected")).to_be_visible()
        expect(page.button("Arm")).to_have_attribute("aria-disabled", "false")
    finally:
        proxy.stop()
        line.close()


def test_draft_outlives_the_session(proxy: PhpProxy, opened: Open, pilot: Pilot, copter: Json) -> None:
    """End to end because a browser's session ends under the page."""
    page = opened(proxy, Pointer())
    key = pilot.api.new_key("draft", "operator")
    page.sign_in_by_key(key)
    page.choose(copter["name"])
    click_waypoints(page, copter)
    drawn = page.waypoints()
    first = page.page.get_by_label("Waypoint 1: height in metres")
    first.fill("12")
    first.press("Tab")
    page.press("Waypoint 2: delete")
    mark = page.page.locator(".draft").last.bounding_box()
    assert mark
    page.page.mouse.move(mark["x"] + mark["width"] / 2, mark["y"] + mark["height"] / 2)
    page.page.mouse.down()
    page.page.mouse.move(mark["x"] + 60, mark["y"] + 60, steps=4)
    page.page.mouse.up()
    left = page.waypoints()
    assert left[0] == Point(drawn[0].latitude, drawn[0].longitude, 12)
    assert left[1].longitude > drawn[2].longitude
    assert left[1].latitude < drawn[2].latitude

    page.page.context.clear_cookies()
    expect(page.page.get_by_text("Your session has ended.")).to_be_visible()
    page.sign_in_by_key(key)
    expect(page.page.get_by_role("heading", name=copter["name"], exact=True)).to_be_visible()
    assert page.waypoints() == left


@pytest.mark.parametrize("by_key", [True, False], ids=["key", "password"])
def test_secrets_are_neither_stored_nor_shown(
    proxy: PhpProxy, opened: Open, pilot: Pilot, by_key: bool
) -> None:
    """End to end because only a browser shows what a page keeps in it."""
    secret = pilot.api.new_key("secret", "operator") if by_key else pilot.password
    page = opened(proxy, Pointer())
    page.sign_in_by_key("not-a-key") if by_key else page.sign_in(pilot.name, "not my password")
    expect(page.page.get_by_role("alert").filter(has_text="Not signed in.")).to_be_visible()
    page.sign_in_by_key(secret) if by_key else page.sign_in(pilot.name, secret)
    expect(page.page.get_by_text("● Connected")).to_be_visible()

    kept = page.page.evaluate(
        """() => JSON.stringify([{...sessionStorage}, {...localStorage}, document.cookie, location.href,
             [...document.querySelectorAll('input')].map((field) => field.value),
             document.documentElement.outerHTML])"""
    )
    assert secret not in kept
    assert "not my password" not in kept
    cookie = page.page.context.cookies()[0]
    assert (cookie.get("httpOnly"), cookie.get("sameSite")) == (True, "Strict")
    assert cookie.get("value", "") not in kept

    token = page.page.evaluate("sessionStorage.getItem('dronemap-token')")
    page.press("Sign out")
    expect(page.button("Sign in")).to_be_visible()
    assert json.loads(page.page.evaluate("JSON.stringify({...sessionStorage})")) == {}
    asked = requests.get(
        f"{proxy.address}/proxy.php?operation=getDronesList",
        headers={"X-Dronemap-Token": token, "Cookie": f"{cookie.get('name')}={cookie.get('value')}"},
        timeout=10,
    )
    assert asked.status_code == 401


def test_who_sees_no_drone_is_told_what_to_do(
    server: Server, proxy: PhpProxy, opened: Open, api: Api
) -> None:
    """End to end because a browser shows the page to somebody who was granted nothing."""
    viewer = new_user(server, api, "viewer")
    assert api.call("PUT", f"/users/{viewer.name}/only-granted", {"onlyGranted": True}).status_code == 204
    page = opened(proxy, Pointer())
    page.sign_in_by_key(viewer.api.new_key("none", "viewer"))
    expect(page.page.get_by_text("No drones yet.")).to_be_visible()
    picture(page, "none")
