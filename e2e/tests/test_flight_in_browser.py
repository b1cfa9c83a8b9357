"""A person flies in the browser: pointer, touch and keyboard; judged from the wire alone."""

import os
import secrets
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, ViewportSize, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, judge, triangle
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.peer import STANDARD_HANDLERS, Peer
from dronemap_e2e.screen import DESK, PHONE, open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import InputMethod, Keyboard, Pointer, Station, Touch
from dronemap_e2e.waiting import wait_for

NAV_WAYPOINT = 16
Open = Callable[..., Station]


@pytest.fixture
def pilot(api: Api) -> tuple[str, str]:
    """Name and password of an operator of the test's own."""
    name, password = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10)
    answer = api.call("POST", "/users", {"name": name, "password": password, "role": "operator"})
    assert answer.status_code == 201, answer.text
    return name, password


@pytest.fixture
def open_station(server: Server, browser: Browser, pilot: tuple[str, str]) -> Iterator[Open]:
    stations: list[Station] = []
    name, password = pilot
    own = secrets.token_hex(10)

    def opened(input_method: InputMethod, size: ViewportSize, dark: bool = False) -> Station:
        stations.append(
            Station(open_page(browser, size, isinstance(input_method, Touch), dark), input_method)
        )
        # The first sign-in wants another password than the one that the administrator knows.
        stations[-1].sign_in(server.address, name, own if len(stations) > 1 else password, own)
        return stations[-1]

    yield opened
    for station in stations:
        station.page.context.close()


def picture(page: Page, name: str) -> None:
    """Kept where DRONEMAP_E2E_SCREENSHOTS says, for people to look at."""
    folder = os.environ.get("DRONEMAP_E2E_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        page.screenshot(path=Path(folder) / f"{name}.png")


def uploaded(wire: VehicleMessages) -> list[Point]:
    """The waypoints that went over the wire, each once, home aside."""
    by_number = {
        h.message.seq: h.message
        for h in wire.messages("MISSION_ITEM_INT", up=False)
        if h.message.command == NAV_WAYPOINT and h.message.seq > 0
    }
    return [Point(m.x / 1e7, m.y / 1e7, m.z) for _, m in sorted(by_number.items())]


def click_waypoints(station: Station, _: Json) -> None:
    """Three places on the map, well apart and away from panels."""
    box = station.page.locator("canvas").first.bounding_box()
    assert box
    left, right, top, height = box["x"], box["x"] + box["width"], box["y"], box["height"]
    if box["width"] > 800:
        left, right = left + 40, right - 40
    for across, down in ((0.45, 0.3), (0.57, 0.27), (0.55, 0.36)):
        station.input_method.tap_map(station.page, left + across * (right - left), top + down * height)


def type_waypoints(station: Station, drone: Json) -> None:
    field = station.page.get_by_label("Add by coordinates")
    for point in triangle(drone["home"]):
        field.fill(f"{point.latitude:.7f}, {point.longitude:.7f}")
        station.press("Add")


@pytest.mark.parametrize(
    ("input_method", "size", "dark", "waypoints"),
    [
        (Pointer(), DESK, False, click_waypoints),
        (Touch(), PHONE, True, click_waypoints),
        (Keyboard(), DESK, True, type_waypoints),
    ],
    ids=["pointer", "touch", "keyboard"],
)
def test_a_person_flies_a_mission(
    request: pytest.FixtureRequest,
    open_station: Open,
    wire: VehicleMessages,
    copter: Json,
    input_method: InputMethod,
    size: ViewportSize,
    dark: bool,
    waypoints: Callable[[Station, Json], None],
) -> None:
    """End to end because hands fly it in a browser, and the judge sees only the wire."""
    name = request.node.callspec.id
    station = open_station(input_method, size, dark)
    station.choose(copter["name"])
    picture(station.page, f"{name}-1-chosen")
    station.hold("Arm")
    expect(station.button("Take off")).to_have_attribute("aria-disabled", "false", timeout=20_000)
    station.page.get_by_label("Take-off altitude (m)").fill("8")
    station.hold("Take off")
    wait_for("it climbs", lambda: _highest(wire) > 7, 60)
    station.press("Plan mission")
    station.page.get_by_label("Waypoint altitude (m)").fill("8")
    waypoints(station, copter)
    picture(station.page, f"{name}-2-planned")
    station.press("Upload mission")
    station.press("Start mission")
    wait_for("all waypoints are reached", lambda: _reached(wire, len(uploaded(wire))), 150)
    picture(station.page, f"{name}-3-flown")
    station.press("Return to launch")
    wait_for("it landed and disarmed", lambda: _disarmed_after_flight(wire), 150)
    station.shows("Disarmed")

    points = uploaded(wire)
    assert len(points) == 3
    judge(wire, points, 8)


def test_page_shows_refusal_text_of_vehicle(server: Server, open_station: Open, api: Api) -> None:
    """End to end because a browser shows what a vehicle of another maker's program says."""
    sentence = f"PreArm: {secrets.token_hex(6)} not healthy"

    def deny(peer: Peer, message: object) -> None:
        peer.send_text(sentence)
        peer.acknowledge(message, 4)

    peer = Peer(server.udp_port, system_id=201, handlers={"COMMAND_LONG": deny})
    try:
        drone = wait_for("listed", lambda: _by_port(api, peer.port))
        station = open_station(Pointer(), DESK)
        station.choose(drone["name"])
        station.hold("Arm")
        station.shows(sentence)
    finally:
        peer.close()


def test_all_open_pages_show_a_lost_drone(server: Server, open_station: Open, api: Api) -> None:
    """End to end because each browser hears it by a stream of its own."""
    peer = Peer(server.udp_port, system_id=202, handlers=STANDARD_HANDLERS)
    try:
        drone = wait_for("listed", lambda: _by_port(api, peer.port))
        pages = [open_station(Pointer(), DESK), open_station(Touch(), PHONE)]
        for page in pages:
            page.choose(drone["name"])
        peer.silent = True
        for page in pages:
            page.shows("Lost", 60)
        peer.silent = False
        for page in pages:
            page.shows("Live")
    finally:
        peer.close()


def _by_port(api: Api, port: int) -> Json | None:
    return next((d for d in api.drones() if d["link"]["port"] == port), None)


def _highest(wire: VehicleMessages) -> float:
    heights = [h.message.relative_alt / 1000 for h in wire.messages("GLOBAL_POSITION_INT", up=True)]
    return max(heights, default=0.0)


def _reached(wire: VehicleMessages, waypoints: int) -> bool:
    """The last item of the mission: take-off and waypoints, behind the home item."""
    last = max((h.message.seq for h in wire.messages("MISSION_ITEM_REACHED", up=True)), default=0)
    return waypoints > 0 and last >= waypoints + 1


def _disarmed_after_flight(wire: VehicleMessages) -> bool:
    beats = [h for h in wire.messages("HEARTBEAT", up=True) if h.message.get_srcComponent() == 1]
    return bool(beats) and not beats[-1].message.base_mode & 0x80
