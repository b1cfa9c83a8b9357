"""Flights remembered: what is found, drawn, replayed and taken along later is what was on the wire."""

import csv
import io
import math
import os
import re
import secrets
import struct
import time
import xml.etree.ElementTree as ElementTree
from bisect import bisect_left
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import duckdb
import pytest
from playwright.sync_api import Browser, Page, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, flight_of, triangle
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.waiting import wait_for

METRES = 1.0
SECONDS = 0.2
# A machine that stands still for a moment takes what it hears late; the way itself stays the same.
STALL_SECONDS = 5.0
IN_TIME = 0.9
SEEKS = 20
EPOCH = datetime.fromtimestamp(0, UTC)
# Notes where the drone is whenever that changes: a slow machine looks on too seldom to see it from outside.
WATCH = """map => {
  window.seenPlaces = [];
  const note = () => window.seenPlaces.push([map.dataset.time, map.dataset.place]);
  new MutationObserver(note).observe(map, { attributes: true, attributeFilter: ['data-time', 'data-place'] });
}"""
SEEK = "(line, time) => { line.value = time; line.dispatchEvent(new Event('input', { bubbles: true })); }"


class WirePositions:
    """Positions that a vehicle reported on the wire, by time of day."""

    def __init__(self, wire: VehicleMessages) -> None:
        offset = time.time() - time.monotonic()
        recorded = wire.messages("GLOBAL_POSITION_INT", up=True)
        self._times = [h.at + offset for h in recorded]
        self._places = [
            (h.message.lat / 1e7, h.message.lon / 1e7, h.message.relative_alt / 1e3) for h in recorded
        ]

    def check(self, places: list[tuple[float, ...]]) -> None:
        """Each (time, latitude, longitude, height) lies on the way flown, nearly all at their time."""
        assert len(places) > 5, f"only {len(places)} places"
        off = [self._metres_off(STALL_SECONDS, *place) for place in places]
        assert max(off) < METRES, f"{max(off):.2f} m off the wire"
        in_time = [self._metres_off(SECONDS, *place) < METRES for place in places]
        share = sum(in_time) / len(places)
        assert share >= IN_TIME, f"{share:.0%} of {len(places)} places at their time"

    def _metres_off(
        self, seconds: float, at: float, latitude: float, longitude: float, height: float
    ) -> float:
        """From the nearest place of the way that it flew within the tolerated time."""
        here = Point(latitude, longitude, height)
        steps = range(-round(seconds / 0.02), round(seconds / 0.02) + 1)
        return min(self._apart(here, at + step * 0.02) for step in steps)

    def _apart(self, here: Point, at: float) -> float:
        latitude, longitude, height = self._at(at)
        return math.hypot(here.metres_to(latitude, longitude), here.altitude - height)

    def _at(self, at: float) -> tuple[float, ...]:
        after = min(max(1, bisect_left(self._times, at)), len(self._times) - 1)
        begin, end = self._times[after - 1], self._times[after]
        share = min(1.0, max(0.0, (at - begin) / max(1e-9, end - begin)))
        both = zip(self._places[after - 1], self._places[after], strict=True)
        return tuple(one + (other - one) * share for one, other in both)


def fly(api: Api, copter: Json) -> Json:
    drone = copter["id"]
    api.do(drone, type="arm")
    api.do(drone, type="takeOff", altitude=8)
    far = triangle(copter["home"], side=30)[1]
    api.do(drone, type="goTo", latitude=far.latitude, longitude=far.longitude, altitude=12)
    wait_for(
        "it is there",
        lambda: (
            far.metres_to(api.drone(drone)["position"]["latitude"], api.drone(drone)["position"]["longitude"])
            < 3
        ),
        90,
    )
    api.do(drone, type="land")
    flight: Json = wait_for("the flight has ended", lambda: flight_of(api, drone, "ended"), 120)
    end = datetime.fromisoformat(flight["end"])

    def all_stored() -> bool:
        """True when telemetry after the flight is stored, and so all of the flight."""
        points = api.get(f"/drones/{drone}/telemetry/points?from={flight['end']}&most=20000")["points"]
        return any(datetime.fromisoformat(point["at"]) > end for point in points)

    wait_for("all of it is stored", all_stored, 60)
    return flight


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png", full_page=True)


def test_flight_replay_and_export_match_the_wire(
    server: Server, api: Api, wire: VehicleMessages, copter: Json, page: Page, tmp_path: Path
) -> None:
    """End to end because a browser plays it, and DuckDB reads its columns."""
    flight = fly(api, copter)
    check_files(api, flight, tmp_path)
    check_replay(server, api, page, copter, WirePositions(wire))


def check_files(api: Api, flight: Json, folder: Path) -> None:
    path = f"/flights/{flight['id']}/telemetry/file?form="
    rows = list(csv.DictReader(io.StringIO(api.text(path + "csv"))))
    assert len(rows) == len(api.get(f"/flights/{flight['id']}/telemetry/points?most=20000")["points"])
    gpx = ElementTree.fromstring(api.text(path + "gpx"))
    assert len(gpx.findall(".//{*}trkpt")) == len([r for r in rows if r["latitude"]])
    kml = ElementTree.fromstring(api.text(path + "kml"))
    assert len(kml.findall(".//{http://www.google.com/kml/ext/2.2}coord")) == len(rows)
    assert api.get(path + "geojson")["features"][0]["geometry"]["type"] == "LineString"
    assert flight["id"] in api.text("/flights/logbook")
    parquet = folder / "flight.parquet"
    parquet.write_bytes(api.content(path + "parquet"))
    check_columns(parquet, rows, flight["drone"])


def check_columns(parquet: Path, rows: list[dict[str, str]], drone: str) -> None:
    """Compares the columns that another program reads with the table, row by row."""
    with duckdb.connect() as database:
        database.execute("SET TimeZone = 'UTC'")
        answer = database.execute(
            'SELECT epoch_us("at") AS micros, * EXCLUDE ("at") FROM read_parquet(?)', [str(parquet)]
        )
        names = [str(column[0]) for column in answer.description or []]
        columns = [dict(zip(names, values, strict=True)) for values in answer.fetchall()]
    assert len(columns) == len(rows)
    for found, row in zip(columns, rows, strict=True):
        assert found["drone_id"] == drone
        assert found["micros"] == (datetime.fromisoformat(row.pop("at")) - EPOCH) // timedelta(microseconds=1)
        assert (found["gps_fix"] is None) == (row.pop("gpsFix") == "")
        for name, text in row.items():
            value = found["phase" if name == "flight" else snake_case(name)]
            assert text == as_text(name, value, text), f"{name} is {value!r}, not {text!r}"


def snake_case(name: str) -> str:
    return re.sub("[A-Z]", lambda letter: "_" + letter[0].lower(), name)


def as_text(name: str, value: object, text: str) -> str:
    """A value as text, as the table writes it."""
    if value is None:
        return ""
    if name in {"flight", "link"}:
        first, *others = str(value).lower().split("_")
        return first + "".join(word.capitalize() for word in others)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int | float):
        # The columns have seven digits of most numbers.
        same = value == float(text) or struct.pack("f", value) == struct.pack("f", float(text))
        return text if same else str(value)
    return str(value)


def check_replay(server: Server, api: Api, page: Page, copter: Json, flown: WirePositions) -> None:
    """Played on the page at ten times its speed, the drone is where it was."""
    name, password = f"viewer-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "viewer"})
    assert answer.status_code == 201, answer.text
    station = Station(page, Pointer())
    station.sign_in(server.address, name, password, secrets.token_hex(10))
    page.get_by_role("button", name="Account of").click()
    page.get_by_role("button", name="Flights", exact=True).click()
    page.get_by_role("button").filter(has_text=copter["name"]).first.click()
    expect(page.get_by_role("figure", name="Altitude above home")).to_be_visible(timeout=30_000)
    replay = page.get_by_role("img", name="Map of the flight")
    expect(replay).not_to_have_attribute("data-place", "", timeout=30_000)
    picture(page, "flights-1-flight")
    replay.evaluate(WATCH)
    page.get_by_role("combobox").first.select_option("10")
    page.get_by_role("button", name="Play", exact=True).click()
    slider = page.get_by_role("slider", name="Moment of the flight")
    end = float(slider.get_attribute("max") or 0)
    wait_for("it is played to its end", lambda: float(replay.get_attribute("data-time") or 0) >= end - 1, 60)
    begin = float(slider.get_attribute("min") or 0)
    for step in range(SEEKS + 1):
        slider.evaluate(SEEK, begin + step / SEEKS * (end - begin))
    seen: dict[str, str] = dict(page.evaluate("window.seenPlaces"))
    assert len(seen) > SEEKS, "it was not played"
    flown.check(
        [(int(at) / 1000, *(float(part) for part in place.split())) for at, place in seen.items() if place]
    )
    picture(page, "flights-2-played")
