"""A person flies by the page of the PHP SOAP proxy; judged by the vehicle's messages and by REST."""

import json
import re
import secrets

import pytest
import requests
from playwright.sync_api import expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, judge
from dronemap_e2e.ground_station import new_user
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.peer import Peer
from dronemap_e2e.php_page import OpenPage, PhpPage, Pilot, Spot
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.screen import PHONE
from dronemap_e2e.server import Server
from dronemap_e2e.station import Keyboard, Pointer, Touch
from dronemap_e2e.waiting import wait_for


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
    # A page on a busy machine may show none of what lies between the ground and that height.
    page.says(re.compile(rf"Take off to {metres} m: (in the air at \d+ m of {metres} m|carried out)"))
    wait_for("it has climbed", lambda: height(api, drone) > metres - 1, 60)


def test_a_person_flies_a_mission_of_clicks(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, wire: VehicleMessages, copter: Json
) -> None:
    """End to end because hands fly it in a browser, by PHP and SOAP, and the judge sees only the wire."""
    page = php_page(php_proxy, Pointer())
    page.sign_in(php_pilot.name, php_pilot.password)
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
    page.says(re.compile(r"Fly to .*: on its way, \d+ m to go"))
    expect(page.target_mark).to_be_visible()
    page.says(re.compile("Fly to .*: arrived"))
    expect(page.target_mark).to_be_hidden()
    assert away(api, copter, target) < 3

    page.click_waypoints(copter["id"])
    drawn = page.waypoints()
    page.picture("planned")
    page.press("Upload to drone")
    page.says("Upload the mission of 3 waypoints. Succeeded.")
    assert are_same(on_board(api, copter), drawn)
    expect(page.page.get_by_text("On the drone", exact=True)).to_be_visible()

    page.page.reload()
    expect(page.page.get_by_text("On the drone", exact=True)).to_be_visible()
    page.press("Clear the draft")
    assert page.waypoints() == []
    page.press("Load from drone")
    page.says("Loaded from the drone: 3 waypoints.")
    expect(page.outcome).to_have_attribute("data-result", "note")
    assert are_same(page.waypoints(), drawn)

    page.is_off("Pause mission", "No mission is running.")
    page.hold("Start mission")
    page.says("Start mission: running, 1 of 3 waypoints reached", 60)
    page.is_off("Start mission", "The mission is running.")
    page.says("Start mission: complete", 60)
    assert len(api.drone(copter["id"])["mission"]["reached"]) >= 4
    page.picture("flown")
    page.press("Return")
    page.says(re.compile("Return to launch: on its way home, .* to go"))
    wait_for("it landed and disarmed", lambda: api.drone(copter["id"])["armed"] is False, 120)
    expect(page.page.get_by_text("On the ground", exact=True).last).to_be_visible()
    page.says("Return to launch: landed and disarmed")
    judge(wire, drawn, 8)


def test_a_phone_flies_and_lands(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api, copter: Json
) -> None:
    """End to end because fingers hold and tap on a small screen."""
    page = php_page(php_proxy, Touch(), PHONE, dark=True)
    page.sign_in(php_pilot.name, php_pilot.password)
    page.choose(copter["name"])
    page.is_off("Delete the mission on the drone", "There is no mission on the drone.")
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

    page.click_waypoints(copter["id"])
    drawn = page.waypoints()
    page.page.get_by_label("At the end").select_option("Return to launch")
    page.press("Upload to drone")
    page.says("Upload the mission of 3 waypoints. Succeeded.")
    assert are_same(on_board(api, copter), drawn)
    assert api.drone(copter["id"])["mission"]["items"][-1] == {"type": "returnToLaunch"}
    page.picture("phone")
    page.press("Hold")
    page.says("Hold. Succeeded.")
    page.press("Land")
    page.says("Land: landing")
    wait_for("it landed and disarmed", lambda: api.drone(copter["id"])["armed"] is False, 120)
    # In LAND it refuses to be armed: its mode is changed first.
    expect(page.button("Arm in GUIDED")).to_contain_text("In LAND it cannot be armed")
    page.hold("Arm in GUIDED")
    page.says("Arm. Succeeded.")
    assert api.drone(copter["id"])["mode"] == "GUIDED"
    page.hold("Disarm")
    page.says("Disarm. Succeeded.")


def test_page_shows_refusal_of_the_vehicle(
    server: Server, php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, api: Api
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
        page = php_page(php_proxy, Keyboard())
        page.sign_in(php_pilot.name, php_pilot.password)
        page.choose(drone["name"])
        page.hold("Arm")
        page.says(f"Arm. Refused by the drone: {sentence}")
        peer.silent = True
        expect(page.page.get_by_text("Lost: not heard").last).to_be_visible(timeout=60_000)
    finally:
        peer.close()


@pytest.mark.parametrize("by_key", [True, False], ids=["key", "password"])
def test_secrets_are_neither_stored_nor_shown(
    php_proxy: PhpProxy, php_page: OpenPage, php_pilot: Pilot, by_key: bool
) -> None:
    """End to end because only a browser shows what a page keeps in it."""
    secret = php_pilot.api.new_key("secret", "operator") if by_key else php_pilot.password
    page = php_page(php_proxy, Pointer())
    page.sign_in_by_key("not-a-key") if by_key else page.sign_in(php_pilot.name, "not my password")
    expect(page.page.get_by_role("alert").filter(has_text="Not signed in.")).to_be_visible()
    page.sign_in_by_key(secret) if by_key else page.sign_in(php_pilot.name, secret)
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
        f"{php_proxy.address}/proxy.php?operation=getDronesList",
        headers={"X-Dronemap-Token": token, "Cookie": f"{cookie.get('name')}={cookie.get('value')}"},
        timeout=10,
    )
    assert asked.status_code == 401


def test_who_sees_no_drone_is_told_what_to_do(
    server: Server, php_proxy: PhpProxy, php_page: OpenPage, api: Api
) -> None:
    """End to end because a browser shows the page to somebody who was granted nothing."""
    viewer = new_user(server, api, "viewer")
    assert api.call("PUT", f"/users/{viewer.name}/only-granted", {"onlyGranted": True}).status_code == 204
    page = php_page(php_proxy, Pointer())
    page.sign_in_by_key(viewer.api.new_key("none", "viewer"))
    expect(page.page.get_by_text("No drones yet.")).to_be_visible()
    page.picture("none")
