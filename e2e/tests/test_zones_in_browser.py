"""Drawing, importing and deleting a no-fly zone on the page."""

import json
import os
import secrets
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.waiting import wait_for


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


def enter(server: Server, api: Api, page: Page, role: str) -> Station:
    name, password = f"{role}-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": role})
    assert answer.status_code == 201, answer.text
    station = Station(page, Pointer())
    station.sign_in(server.address, name, password, secrets.token_hex(10))
    page.get_by_role("button").filter(has_text="Zones").click()
    return station


def named(api: Api, name: str) -> Json | None:
    zones: list[Json] = api.get("/zones")["features"]
    return next((zone for zone in zones if zone["properties"]["name"] == name), None)


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def test_supervisor_draws_imports_and_deletes_zones(
    server: Server, api: Api, page: Page, copter: Json, tmp_path: Path
) -> None:
    """End to end because a browser is drawn in, and takes a file."""
    drawn = f"Park {secrets.token_hex(3)}"
    station = enter(server, api, page, "supervisor")
    station.choose(copter["name"])
    station.press("Draw an area")
    box = page.get_by_role("application", name="Map").bounding_box()
    assert box
    east, south = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    for dx, dy in ((-150, -150), (-40, -150), (-40, -60), (-150, -60)):
        page.mouse.click(east + dx, south + dy)
        page.wait_for_timeout(400)
    page.get_by_label("Name", exact=True).fill(drawn)
    page.get_by_label("Ceiling, m", exact=True).fill("80")
    page.get_by_label("Applies to").select_option("one drone")
    expect(page.get_by_role("combobox", name="Drone", exact=True)).to_have_value(copter["id"])
    picture(page, "zones-1-drawing")
    station.press("Save the zone")
    station.shows(f"keep out · up to 80 m above home · only {copter['name']} · on breach hold")
    picture(page, "zones-2-list")
    zone = wait_for("it is kept", lambda: named(api, drawn), 30)
    assert len(zone["geometry"]["coordinates"][0]) == 5
    assert zone["properties"]["drone"] == copter["id"]

    station.press(f"Change {drawn}")
    page.get_by_label("Applies to").select_option("everybody")
    page.get_by_label("Floor and ceiling are").select_option("above sea level")
    page.get_by_label("Until (empty: no end)").fill("2099-05-04T10:00")
    picture(page, "zones-3-changing")
    station.press("Save the zone")
    station.shows("keep out · up to 80 m above sea level · until")
    changed = wait_for("it is changed", lambda: named(api, drawn), 30)
    assert changed["id"] == zone["id"] and changed["geometry"] == zone["geometry"]
    assert changed["properties"]["until"] and changed["properties"]["drone"] is None

    imported = f"Lake {secrets.token_hex(3)}"
    file = tmp_path / "lake.geojson"
    ring = [[-30, 10], [-30.01, 10], [-30, 10.01], [-30, 10]]
    lake = {
        "type": "Feature",
        "properties": {"name": imported, "colour": "blue"},
        "geometry": {"type": "Polygon", "coordinates": [ring]},
    }
    file.write_text(json.dumps(lake))
    page.get_by_label("Import GeoJSON, KML or KMZ").set_input_files(file)
    station.shows(imported)

    for name in (drawn, imported):
        station.input_method.hold(page, station.button(f"Delete {name}"))
        expect(station.button(f"Delete {name}")).to_be_hidden()
        assert named(api, name) is None


def test_operator_sees_zones_read_only(server: Server, api: Api, page: Page, copter: Json) -> None:
    """End to end because a browser offers nothing that is refused."""
    name = f"School {secrets.token_hex(3)}"
    circle = {"type": "Point", "coordinates": [-31, 11]}
    added = api.call(
        "POST", "/zones", {"type": "Feature", "geometry": circle, "properties": {"name": name, "radius": 50}}
    )
    assert added.status_code == 201, added.text
    station = enter(server, api, page, "operator")
    station.shows(name)
    expect(station.button("Draw an area")).to_be_hidden()
    expect(station.button(f"Delete {name}")).to_be_hidden()
    assert api.call("DELETE", f"/zones/{added.json()['id']}").status_code == 204
    expect(page.get_by_text(name)).to_be_hidden()
