"""A person plans the landing of a plane in the browser, on the map; judged by what the vehicle then holds."""

import secrets
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import DESK, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.waiting import wait_for

SYSTEM_ID = 47


@pytest.fixture
def plane(server: Server, api: Api, tmp_path: Path) -> Iterator[Json]:
    link = f"udp://127.0.0.1:{server.udp_port}"
    arguments = ("--personality", "arduplane", "--sysid", str(SYSTEM_ID))
    simulator = Simulator(tmp_path / "plane.log", link, *arguments)
    yield wait_for("the plane has a home", lambda: _with_home(api), 90)
    simulator.stop()


@pytest.fixture
def station(server: Server, api: Api, browser: Browser) -> Iterator[Station]:
    name, password, own = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    opened = Station(open_page(browser, DESK, False, False), Pointer())
    opened.sign_in(server.address, name, password, own)
    yield opened
    opened.page.context.close()


def _with_home(api: Api) -> Json | None:
    return next((d for d in api.drones() if d["link"]["systemId"] == SYSTEM_ID and d["home"]), None)


def _held(api: Api, drone: str) -> list[Json]:
    return api.get(f"/drones/{drone}")["mission"]["items"] or []


def test_plane_is_given_a_landing_place_on_the_map(station: Station, plane: Json, api: Api) -> None:
    """End to end because a browser draws the map, and the server says whether a way down will do."""
    page = station.page
    station.choose(plane["name"])
    station.press("Plan take-off and landing")
    planned = page.get_by_role("list", name="Planned mission")
    expect(planned).to_contain_text("Take off to 50 m")
    home = f"{plane['home']['latitude']:.6f}, {plane['home']['longitude']:.6f}"
    expect(planned).to_contain_text(f"Land at {home}")

    # Half the way to where the approach begins is too near for its height.
    station.press("Set on the map")
    box = page.get_by_role("application", name="Map").bounding_box()
    assert box
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(planned).not_to_contain_text(home)
    station.press("Upload mission")
    refused = planned.get_by_role("listitem").filter(has_text="Land at")
    expect(refused.get_by_role("alert")).to_contain_text("lands on a straight way down to a place")
    assert _held(api, plane["id"]) == []

    station.press("Undo")
    expect(planned.get_by_role("alert")).to_have_count(0)
    station.press("Upload mission")
    items = wait_for("the vehicle holds it", lambda: _held(api, plane["id"]), 30)
    assert [item["type"] for item in items] == ["takeOff", "waypoint", "land"]
    assert abs(items[2]["latitude"] - plane["home"]["latitude"]) < 1e-6
    assert abs(items[2]["longitude"] - plane["home"]["longitude"]) < 1e-6
