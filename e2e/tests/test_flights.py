"""Flights remembered: what is found, drawn, replayed and taken along later is what was on the wire."""

import csv
import io
import os
import secrets
import time
import xml.etree.ElementTree as ElementTree
from bisect import bisect_left
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect, sync_playwright

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, triangle
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station, launch
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import wait_for

METRES = 1.0
SECONDS = 0.2
# A machine that stands still for a moment takes what it hears late; the way itself stays the same.
STALL_SECONDS = 5.0
IN_TIME = 0.9
SEEKS = 20
# Notes where the drone is whenever that changes: a slow machine looks on too seldom to see it from outside.
WATCH = """map => {
  window.seenPlaces = [];
  const note = () => window.seenPlaces.push([map.dataset.time, map.dataset.place]);
  new MutationObserver(note).observe(map, { attributes: true, attributeFilter: ['data-time', 'data-place'] });
}"""
SEEK = "(line, time) => { line.value = time; line.dispatchEvent(new Event('input', { bubbles: true })); }"


class Wire:
    """Where a vehicle said that it was, by the time of day when it was heard."""

    def __init__(self, tap: Tap) -> None:
        offset = time.time() - time.monotonic()
        heard = tap.heard("GLOBAL_POSITION_INT", up=True)
        self._times = [h.at + offset for h in heard]
        self._places = [(h.message.lat / 1e7, h.message.lon / 1e7) for h in heard]

    def check(self, places: list[tuple[float, ...]]) -> None:
        """Each (time, latitude, longitude) lies on the way that was flown, nearly all at their time."""
        assert len(places) > 5, f"only {len(places)} places"
        off = [self._metres_off(STALL_SECONDS, *place) for place in places]
        assert max(off) < METRES, f"{max(off):.2f} m off the wire"
        in_time = [self._metres_off(SECONDS, *place) < METRES for place in places]
        share = sum(in_time) / len(places)
        assert share >= IN_TIME, f"{share:.0%} of {len(places)} places at their time"

    def _metres_off(self, seconds: float, at: float, latitude: float, longitude: float) -> float:
        """From the nearest place of the way that it flew within the tolerated time."""
        here = Point(latitude, longitude, 0)
        steps = range(-round(seconds / 0.02), round(seconds / 0.02) + 1)
        return min(here.metres_to(*self._at(at + step * 0.02)) for step in steps)

    def _at(self, at: float) -> tuple[float, float]:
        after = min(max(1, bisect_left(self._times, at)), len(self._times) - 1)
        begin, end = self._times[after - 1], self._times[after]
        share = min(1.0, max(0.0, (at - begin) / max(1e-9, end - begin)))
        (lat, lon), (lat2, lon2) = self._places[after - 1], self._places[after]
        return lat + (lat2 - lat) * share, lon + (lon2 - lon) * share


def seconds_of(iso: str) -> float:
    return datetime.fromisoformat(iso.replace("Z", "+00:00")).timestamp()


def flight_of(api: Api, drone: str, state: str) -> Json | None:
    flights = api.get(f"/flights?drone={drone}")["flights"]
    return flights[0] if flights and flights[0]["state"] == state else None


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
    return wait_for("the flight has ended", lambda: flight_of(api, drone, "ended"), 120)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        started = launch(playwright)
        yield started
        started.close()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    yield context.new_page()
    context.close()


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png", full_page=True)


def test_a_flight_is_remembered_as_it_was_on_the_wire(
    server: Server, api: Api, tap: Tap, copter: Json, page: Page
) -> None:
    flight = fly(api, copter)
    wire = Wire(tap)
    check_what_is_remembered(api, flight, wire)
    check_files(api, flight)
    check_replay(server, api, page, copter, wire)


def check_what_is_remembered(api: Api, flight: Json, wire: Wire) -> None:
    assert 35 < flight["distance"] < 60
    assert 10 < flight["highest"] < 15
    assert flight["users"] == [api.get("/session")["name"]]
    assert len(flight["recordings"]) == 1
    points = api.get(f"/flights/{flight['id']}/telemetry/points")["points"]
    assert len(points) > flight["seconds"]
    wire.check([(seconds_of(p["at"]), p["latitude"], p["longitude"]) for p in points])
    # States and events are written in batches of their own, a moment later than the flight.
    events: list[Json] = wait_for("its end is told", lambda: with_end(api, flight), 30)
    commands = {e["text"]: e["result"] for e in events if e["kind"] == "command"}
    assert commands["take off to 8 m"] == "succeeded", commands
    assert {"armed", "disarmed", "mode"} <= {e["kind"] for e in events}
    series = api.get(f"/flights/{flight['id']}/telemetry?fields=altitudeAboveHome&slots=7")
    highest = max(p["altitudeAboveHome"] for p in points)
    assert max(series["fields"][0]["most"]) == pytest.approx(highest, abs=0.01)


def with_end(api: Api, flight: Json) -> list[Json] | None:
    events: list[Json] = api.get(f"/flights/{flight['id']}/events")["events"]
    return events if any(e["kind"] == "disarmed" for e in events) else None


def check_files(api: Api, flight: Json) -> None:
    path = f"/flights/{flight['id']}/telemetry/file?form="
    rows = list(csv.DictReader(io.StringIO(api.text(path + "csv"))))
    assert len(rows) == len(api.get(f"/flights/{flight['id']}/telemetry/points?most=20000")["points"])
    gpx = ElementTree.fromstring(api.text(path + "gpx"))
    assert len(gpx.findall(".//{*}trkpt")) == len([r for r in rows if r["latitude"]])
    kml = ElementTree.fromstring(api.text(path + "kml"))
    assert len(kml.findall(".//{http://www.google.com/kml/ext/2.2}coord")) == len(rows)
    assert api.get(path + "geojson")["features"][0]["geometry"]["type"] == "LineString"
    assert flight["id"] in api.text("/flights/logbook")


def check_replay(server: Server, api: Api, page: Page, copter: Json, wire: Wire) -> None:
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
    wire.check(
        [(int(at) / 1000, *(float(part) for part in place.split())) for at, place in seen.items() if place]
    )
    picture(page, "flights-2-played")


def test_a_flight_goes_on_over_a_crash_and_loses_a_second_at_most(tmp_path: Path) -> None:
    server = Server(tmp_path / "data")
    server.start()
    simulator = Simulator(
        tmp_path / "sim.log", f"udp://127.0.0.1:{server.udp_port}", "--count", "1", "--speedup", "3"
    )
    try:
        api = Api(server.address, server.local_key())
        drone = wait_for("the copter is ready", lambda: api.ready(1), 90)["id"]
        api.do(drone, type="arm")
        api.do(drone, type="takeOff", altitude=8)
        before = wait_for("the flight is known", lambda: flight_of(api, drone, "running"), 30)
        wait_for("telemetry is kept", lambda: len(points(api, before)) > 20, 60)
        killed = time.time()
        server.kill()
        server.start()
        api = Api(server.address, server.local_key())
        lost = killed - max(seconds_of(p["at"]) for p in points(api, before) if seconds_of(p["at"]) < killed)
        # Half a second by itself; the rest is for machines that are slow to write it down.
        assert lost < 4, f"{lost:.1f} s of telemetry are missing"
        wait_for("it is heard again", lambda: flight_of(api, drone, "running"), 60)
        api.do(drone, type="land")
        after = wait_for("the flight has ended", lambda: flight_of(api, drone, "ended"), 120)
        assert after["id"] == before["id"]
        assert after["start"] == before["start"]
        assert len(api.get(f"/flights?drone={drone}")["flights"]) == 1
    finally:
        simulator.stop()
        server.stop()


def points(api: Api, flight: Json) -> list[Json]:
    found: list[Json] = api.get(f"/flights/{flight['id']}/telemetry/points")["points"]
    return found
