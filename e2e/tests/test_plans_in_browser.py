"""A mission for several drones on the page: from "Select all" to "Start" in four clicks, and its run.

Two plans compared; what nobody visits, and why; the best order for one drone by one click; a waypoint
cancelled in flight, with the reason told; the end, and its journal."""

import os
import re
import secrets
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.waiting import wait_for

DRONES = 3
# For one drone: none lies where one of the others does, whose tap would be one at a waypoint while the map
# still shows the former.
FORMER_PLACES = ((-150, -90), (110, -140), (-70, -100), (150, -70))
PLACES = ((-180, -60), (-110, -120), (-30, -150), (60, -150), (130, -110), (170, -40))


@pytest.fixture
def fleet(tmp_path: Path) -> Iterator[Server]:
    """A server of its own, so that all drones are these."""
    server = Server(tmp_path / "data")
    server.start()
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{server.udp_port}",
        *("--count", str(DRONES), "--sysid", "1"),
        *QUICK_FLIGHT,
    )
    yield server
    simulator.stop()
    server.stop()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at: by night and by day."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if not folder:
        return
    Path(folder).mkdir(parents=True, exist_ok=True)
    for scheme in ("dark", "light"):
        page.emulate_media(color_scheme="dark" if scheme == "dark" else "light")
        page.wait_for_timeout(400)
        page.screenshot(path=Path(folder) / f"{name}-{scheme}.png")


def count_presses(page: Page) -> None:
    page.evaluate(
        "() => { window.presses = 0; addEventListener('pointerdown', () => { window.presses += 1 }, true) }"
    )


def presses(page: Page) -> int:
    count: int = page.evaluate("() => window.presses")
    return count


def _known(api: Api) -> bool:
    drones = [api.ready(system_id) for system_id in range(1, DRONES + 1)]
    return all(d and d["battery"] and d["link"]["quality"]["lossShort"] is not None for d in drones)


def tap_places(page: Page, places: tuple[tuple[int, int], ...]) -> None:
    """Pixels east and south of the middle of the map; each is a waypoint before the next is tapped."""
    for number, (east, south) in enumerate(places, start=1):
        box = page.get_by_role("application", name="Map").bounding_box()
        assert box
        page.mouse.click(box["x"] + box["width"] / 2 + east, box["y"] + box["height"] / 2 + south)
        expect(page.get_by_text(re.compile(rf"\b{number} waypoints?\b")).first).to_be_visible()


def _place_of(page: Page, waypoint: str) -> Json:
    """Place of a waypoint in the newest plan of the signed-in user."""
    place: Json = page.evaluate(
        """async (waypoint) => {
          const all = await (await fetch('/api/v1/plans')).json();
          const plan = await (await fetch(`/api/v1/plans/${all.plans.at(-1).id}`)).json();
          return plan.result.tours.flatMap((tour) => tour.stops).find((stop) => stop.waypoint === waypoint);
        }""",
        waypoint,
    )
    return place


def _forbid(api: Api, place: Json) -> None:
    answer = api.call(
        "POST",
        "/zones",
        {
            "type": "Feature",
            "geometry": {"type": "Point", "coordinates": [place["longitude"], place["latitude"]]},
            "properties": {"name": "Crane", "kind": "exclusion", "radius": 8},
        },
    )
    assert answer.status_code == 201, answer.text


def test_plan_start_and_change_run_of_three_drones(fleet: Server, page: Page) -> None:
    """End to end because a browser draws it all on its map."""
    api = Api(fleet.address, fleet.local_key())
    wait_for("all is known", lambda: _known(api), 150)
    name, password = f"operator-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    station = Station(page, Pointer())
    station.sign_in(fleet.address, name, password, secrets.token_hex(10))

    # One drone: the best order by one click, and back.
    station.choose("ArduCopter 1")
    station.press("Plan mission")
    tap_places(page, FORMER_PLACES)
    station.press("Best order")
    station.shows("instead of")
    picture(page, "plans-0-best-order")
    station.press("Undo")
    station.press("Stop planning")
    station.press("Close ArduCopter 1")

    section = page.get_by_role("button").filter(has_text="Multi-drone plan")
    section.click()
    tap_places(page, PLACES)
    station.shows(f"{len(PLACES)} waypoints")
    picture(page, "plans-1-waypoints")

    # Two plans side by side, then back to the one for the earliest end.
    page.get_by_role("button").filter(has_text="Options").click()
    page.get_by_label("Search for (s)").fill("1")
    plan = page.get_by_role("article", name="Plan")
    station.press("Select all")
    station.press("Plan")
    expect(plan).to_contain_text("All done after", timeout=60_000)
    page.get_by_label("Optimise").select_option("leastDistance")
    station.press("Plan")
    comparison = page.get_by_role("table")
    expect(comparison).to_contain_text("distance in all", timeout=60_000)
    bars = page.get_by_role("list", name="When each drone is done, in both plans")
    expect(bars.get_by_role("listitem")).to_have_count(DRONES)
    picture(page, "plans-2-compared")
    page.get_by_label("Optimise").select_option("earliestEnd")

    # Another one lies where nobody may fly.
    _forbid(api, _place_of(page, str(len(PLACES))))
    count_presses(page)
    station.press("Select all")
    station.press("Plan")
    left_out = page.get_by_role("region", name="Left out")
    expect(left_out).to_contain_text("the no-fly zone “Crane”", timeout=60_000)
    picture(page, "plans-3-left-out")
    station.input_method.hold(page, station.button("Start"))
    assert presses(page) <= 4

    run = page.get_by_role("region", name="Run Mission run")
    expect(run.get_by_text("flying", exact=True).first).to_be_visible(timeout=60_000)
    run.get_by_role("button", name=re.compile("^Waypoints")).click()
    # The one whose turn comes last.
    run.get_by_role("button").filter(has_text="to be visited by").last.click()
    cancel = run.get_by_role("button", name=re.compile("Cancel waypoint"))
    number = cancel.inner_text().removeprefix("Cancel waypoint ")
    station.input_method.hold(page, cancel)
    decisions = run.get_by_role("region", name="Decisions")
    expect(decisions).to_contain_text(f"{name} cancelled the waypoint {number}.", timeout=20_000)
    expect(run.get_by_role("list", name="Waypoints", exact=True)).to_contain_text("cancelled")
    picture(page, "runs-1-cancelled")

    expect(run.get_by_role("status").first).to_contain_text("The run is over", timeout=120_000)
    run.get_by_role("button").filter(has_text="Journal").click()
    station.press("Replay the journal")
    station.shows("no difference")
    picture(page, "runs-2-over")

    # Everything is open at once: the page keeps its height, and the map serves the run alone.
    page.get_by_role("button", name="Set waypoints on the map").click()
    station.shows("Click to add waypoints")
    shelf = page.get_by_role("region", name="Runs", exact=True)
    shelf.get_by_role("button").first.click()
    shelf.locator("button[aria-pressed]").first.click()
    expect(page.get_by_text("Click to add waypoints")).to_have_count(0)
    assert page.evaluate("document.documentElement.scrollHeight <= innerHeight")
    picture(page, "runs-3-all-open")
