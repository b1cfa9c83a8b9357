"""The page of the PHP SOAP proxy on a screen that is smaller than what it shows."""

import re

from playwright.sync_api import expect

from dronemap_e2e.api import Json
from dronemap_e2e.php_page import OpenPage, Pilot, Spot
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.screen import PHONE
from dronemap_e2e.station import Touch
from dronemap_e2e.waiting import wait_for


def test_phone_keeps_map_and_buttons_in_reach(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, copter: Json
) -> None:
    """End to end because fingers scroll, tap and drag on a small screen."""
    page = php_page(php_proxy, Touch(), PHONE)
    page.sign_in(php_pilot.name, php_pilot.password)
    page.choose(copter["name"])
    expect(page.page.locator("#drone-list")).to_be_hidden()
    expect(page.button("Arm")).to_be_in_viewport()
    page.picture("phone-chosen")

    page.click_waypoints(copter["id"])
    expect(page.page.get_by_text("Tap to add waypoints")).to_be_visible()
    expect(page.page.locator("#map-place")).to_be_hidden()
    first, _, third = page.waypoints()
    spot = page.centre(".draft")
    page.swipe(spot, Spot(spot.x - 40, spot.y + 30))
    wait_for("the finger has moved it", lambda: page.waypoints()[2].longitude < third.longitude)
    assert page.waypoints()[0] == first

    before, scrolled = page.inside_map(copter["id"]), page.page.evaluate("scrollY")
    page.swipe(Spot(40, 300), Spot(60, 120))
    wait_for("the finger has scrolled the page", lambda: page.page.evaluate("scrollY") > scrolled)
    assert page.inside_map(copter["id"]) == before
    expect(page.map).to_be_in_viewport(ratio=0.9)
    page.page.get_by_role("button", name=re.compile("Start mission")).scroll_into_view_if_needed()
    expect(page.map).to_be_in_viewport(ratio=0.9)
    page.picture("phone-mission")
