"""The page of the PHP SOAP proxy when answers are lost, lines are cut, and sessions end."""

import re
from pathlib import Path

from playwright.sync_api import Route, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.cuttable_proxy import CuttableProxy
from dronemap_e2e.flight import Point
from dronemap_e2e.php_page import OpenPage, Pilot
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.server import Server
from dronemap_e2e.station import Keyboard, Pointer
from dronemap_e2e.waiting import throughout, wait_for

UNKNOWN = "Not known whether it was carried out"


def test_lost_answer_is_shown_as_not_known_and_then_cleared_up(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because the connection of a browser breaks under a command."""
    page = php_page(php_proxy, Keyboard())
    page.sign_in_by_key(php_pilot.api.new_key("page", "operator"))
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
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because a browser keeps it by a timer of its own."""
    page = php_page(php_proxy, Pointer())
    page.sign_in(php_pilot.name, php_pilot.password)
    page.choose(copter["name"])
    page.press("Take control")
    expect(page.page.get_by_text("You have control while this page is open and in sight.")).to_be_visible()

    def held() -> bool:
        control = api.drone(copter["id"])["control"]
        return bool(control["explicit"]) and control["holder"] == php_pilot.name

    throughout("its pilot has control", held, 8)


def test_line_to_the_server_that_is_cut(
    server: Server, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json, tmp_path: Path
) -> None:
    """End to end because a line is cut between PHP and the server."""
    line = CuttableProxy(server.http_port)
    proxy = PhpProxy(f"http://127.0.0.1:{line.port}", tmp_path, DRONEMAP_PHP_PATIENCE="10")
    proxy.start()
    try:
        page = php_page(proxy, Pointer())
        page.sign_in_by_key(php_pilot.api.new_key("cut", "operator"))
        page.choose(copter["name"])
        expect(page.button("Arm")).to_have_attribute("aria-disabled", "false")
        line.cut()
        expect(page.page.get_by_role("alert").filter(has_text="No connection to the drones.")).to_be_visible()
        expect(page.page.get_by_text(re.compile(r"^What is shown is \d+ s old"))).to_be_visible()
        expect(page.button("Arm")).to_have_attribute("aria-disabled", "true")
        page.picture("cut")
        line.restore()
        expect(page.page.get_by_text("● Connected")).to_be_visible()
        expect(page.button("Arm")).to_have_attribute("aria-disabled", "false")
        proxy.stop()
        page.press("Sign out")
        expect(page.page.get_by_role("alert").filter(has_text="You are still signed in.")).to_be_visible()
    finally:
        proxy.stop()
        line.close()


def test_flight_that_nobody_hears_of_is_not_told_as_seen(
    server: Server, php_page: OpenPage, php_pilot: Pilot, copter: Json, tmp_path: Path
) -> None:
    """End to end because a line is cut between PHP and the server while a drone climbs."""
    line = CuttableProxy(server.http_port)
    proxy = PhpProxy(f"http://127.0.0.1:{line.port}", tmp_path, DRONEMAP_PHP_PATIENCE="10")
    proxy.start()
    try:
        page = php_page(proxy, Pointer())
        page.sign_in_by_key(php_pilot.api.new_key("cut", "operator"))
        page.choose(copter["name"])
        page.hold("Arm")
        expect(page.button("Take off")).to_have_attribute("aria-disabled", "false")
        page.page.get_by_label("Take-off height").fill("100")
        page.hold("Take off")
        expect(page.page.locator("#outcome-words")).to_contain_text("in the air")
        line.cut()
        expect(page.page.locator("#outcome-words")).to_contain_text(
            re.compile(r"^No connection to the server\. Last heard: Take off")
        )
        line.restore()
        expect(page.page.locator("#outcome-words")).to_contain_text(re.compile(r"^Take off"))
    finally:
        proxy.stop()
        line.close()


def test_draft_outlives_the_session(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, copter: Json
) -> None:
    """End to end because a browser's session ends under the page."""
    page = php_page(php_proxy, Pointer())
    key = php_pilot.api.new_key("draft", "operator")
    page.sign_in_by_key(key)
    page.choose(copter["name"])
    page.click_waypoints(copter["id"])
    drawn = page.waypoints()
    first = page.page.get_by_label("Waypoint 1: height in metres")
    first.fill("12")
    first.press("Tab")
    page.press("Waypoint 2: delete")
    mark = page.centre(".draft")
    page.page.mouse.move(mark.x, mark.y)
    page.page.mouse.down()
    page.page.mouse.move(mark.x + 45, mark.y + 45, steps=4)
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
