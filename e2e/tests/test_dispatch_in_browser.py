"""A person sends a drone to a place on the map, on a desk and on a phone; judged by where it then is."""

import secrets
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, ViewportSize, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point
from dronemap_e2e.screen import DESK, PHONE, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import InputMethod, Pointer, Station, Touch
from dronemap_e2e.waiting import wait_for
from dronemap_e2e.walker import picture

BESIDE_PIXELS = 70


@pytest.fixture
def lent(api: Api, copter: Json) -> Iterator[Json]:
    """The test's copter, in the pool."""
    assert api.call("PUT", f"/warehouse/{copter['id']}", {}).ok
    yield copter
    api.call("DELETE", f"/warehouse/{copter['id']}")


def signed_in(
    server: Server, api: Api, browser: Browser, hand: InputMethod, size: ViewportSize
) -> tuple[Station, str]:
    name, password, own = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    station = Station(open_page(browser, size, size is PHONE, False), hand)
    station.sign_in(server.address, name, password, own)
    return station, name


@pytest.mark.parametrize(("hand", "size"), [(Pointer(), DESK), (Touch(), PHONE)], ids=["desk", "phone"])
def test_a_person_sends_a_drone_to_a_place(
    server: Server, api: Api, browser: Browser, lent: Json, hand: InputMethod, size: ViewportSize
) -> None:
    """End to end because a place is marked by a hand on a map that a browser draws."""
    kind = "phone" if size is PHONE else "desk"
    station, name = signed_in(server, api, browser, hand, size)
    page = station.page
    # The map flies to the one that is chosen; with none chosen, a press means any.
    station.choose(lent["name"])
    page.wait_for_timeout(1500)
    page.keyboard.press("Escape")
    box = page.get_by_role("application", name="Map").bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2 + BESIDE_PIXELS, box["y"] + box["height"] * 0.3
    if size is PHONE:
        station.press("Send a drone")
        expect(page.get_by_text("Tap to mark where a drone is wanted")).to_be_visible()
        hand.tap_map(page, x, y)
    else:
        page.mouse.move(x, y)
        page.mouse.down()
        page.wait_for_timeout(900)
        page.mouse.up()
    card = page.get_by_role("dialog", name="Send a drone here")
    expect(card).to_be_visible()
    picture(page, f"send-{kind}-1-place")
    card.get_by_label("Height above take-off (m)").fill("12")
    station.press("Send the best drone")
    picture(page, f"send-{kind}-2-sent")
    sent = page.get_by_role("region", name="Drone that was sent")
    expect(sent).to_contain_text("on its way", timeout=120_000)
    picture(page, f"send-{kind}-3-on-its-way")
    expect(sent).to_contain_text("is here: control is yours", timeout=120_000)

    dispatch = next(one for one in api.get("/dispatches")["dispatches"] if one["owner"] == name)
    place = Point(dispatch["latitude"], dispatch["longitude"], 12)
    position = api.drone(lent["id"])["position"]
    assert place.metres_to(position["latitude"], position["longitude"]) < 7
    control = wait_for("the page keeps it", lambda: kept(api, lent["id"], name), 20)
    assert control["explicit"]
    page.wait_for_timeout(3000)
    picture(page, f"send-{kind}-4-here")

    station.press("Call off")
    wait_for("it is down at home", lambda: api.drone(lent["id"])["armed"] is False, 90)
    page.context.close()


def kept(api: Api, drone: str, name: str) -> Json | None:
    control: Json = api.drone(drone)["control"]
    return control if control["holder"] == name else None
