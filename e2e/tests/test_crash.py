"""The server killed with -9 in mid-mission, and what it says when it is back."""

import secrets
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, sync_playwright
from pymavlink import mavutil

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import COPTER_RTL, items, triangle
from dronemap_e2e.peer import Peer, with_hardware
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station, launch
from dronemap_e2e.stopwatch import Stopwatch
from dronemap_e2e.waiting import wait_for

# On the wire the home position is item 0 and the take-off item 1.
HOME_ITEM = 1
FIRST_WAYPOINT = 1
# So soon after a restart all is shown again.
RETURN_SECONDS = 15


@pytest.fixture
def own_server(tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Server]:
    """As shipped for one of the tests: the second compiler takes as long again to start."""
    started = Server(tmp_path / "data", as_shipped="continue" in request.node.name)
    started.start()
    yield started
    started.stop()


@pytest.fixture
def in_mission(own_server: Server, tmp_path: Path) -> Iterator[tuple[Api, Json]]:
    """A copter that has just begun a mission of three waypoints."""
    simulator = Simulator(tmp_path / "sim.log", f"udp://127.0.0.1:{own_server.udp_port}", "--count", "1")
    api = Api(own_server.address, own_server.local_key())
    drone = wait_for("the copter is ready", lambda: api.ready(1), 90)
    api.do(drone["id"], type="arm")
    api.do(drone["id"], type="takeOff", altitude=10)
    wait_for("it hovers", lambda: api.drone(drone["id"])["position"]["altitudeAboveHome"] > 9, 60)
    points = triangle(drone["home"], altitude=10, side=25)
    api.do(drone["id"], type="uploadMission", items=items(points))
    yield api, drone
    simulator.stop()


@pytest.fixture
def page() -> Iterator[Page]:
    with sync_playwright() as playwright:
        browser = launch(playwright)
        yield browser.new_page(viewport={"width": 1440, "height": 900})
        browser.close()


def open_page(page: Page, server: Server, api: Api, drone: Json) -> Station:
    """Signed in before the crash, with the drone's panel open."""
    pilot = {"name": "pilot", "password": secrets.token_hex(10), "role": "operator"}
    assert api.call("POST", "/users", pilot).status_code == 201
    station = Station(page, Pointer())
    station.sign_in(server.address, pilot["name"], pilot["password"], secrets.token_hex(10))
    station.choose(drone["name"])
    return station


def restart(server: Server) -> tuple[Api, Stopwatch]:
    watch = Stopwatch()
    server.start()
    return Api(server.address, server.local_key()), watch


@pytest.mark.parametrize("on_cloud_loss", ["continue", "rtl"])
def test_after_a_crash_the_vehicles_own_item_is_shown(
    own_server: Server, in_mission: tuple[Api, Json], on_cloud_loss: str
) -> None:
    api, drone = in_mission
    api.do(drone["id"], type="startMission", onCloudLoss=on_cloud_loss)
    wait_for("it heads for the first waypoint", lambda: api.drone(drone["id"])["mission"]["current"] == 1)
    own_server.kill()
    _watch(own_server.udp_port, on_cloud_loss)
    again, watch = restart(own_server)

    back = wait_for("it is back", lambda: _live(again, drone["id"]), 60)
    now = wait_for("its mission was read", lambda: _with_mission(again, drone["id"]), 60)

    watch.expect_at_most(RETURN_SECONDS)
    assert back["id"] == drone["id"]
    assert len(now["mission"]["items"]) == 4
    if on_cloud_loss == "continue":
        assert now["mode"] == "AUTO"
        wait_for("it heads for the last", lambda: (again.drone(drone["id"])["mission"]["current"] or 0) >= 3)
        said = ("flew on from item 2", "flew its mission to the end")
        wait_for(
            "it says so", lambda: any(sentence in text for text in _texts(again, drone) for sentence in said)
        )
    else:
        assert now["mode"] == "RTL"


def test_after_a_crash_a_mission_of_somebody_else_is_noticed(
    own_server: Server, in_mission: tuple[Api, Json], page: Page
) -> None:
    api, drone = in_mission
    station = open_page(page, own_server, api, drone)
    api.do(drone["id"], type="startMission")
    own_server.kill()
    _replace_mission(own_server.udp_port, drone["home"])

    again, watch = restart(own_server)
    now = wait_for("its mission was read", lambda: _with_mission(again, drone["id"]), 60)

    station.shows("2 items instead of 4", 60)
    watch.expect_at_most(RETURN_SECONDS)
    assert len(now["mission"]["items"]) == 2
    assert "2 items instead of 4" in now["mission"]["notice"]


def test_after_a_crash_vehicles_hear_the_server_before_its_pages_are_there(own_server: Server) -> None:
    """Pages take most of a start; ArduPilot flies home when it hears nothing for five seconds."""
    api = Api(own_server.address, own_server.local_key())
    peer = Peer(own_server.udp_port, system_id=7, handlers={"COMMAND_LONG": with_hardware(0x5107)})
    wait_for("it is known", lambda: len(api.drones()) == 1)
    wait_for("it hears the server", lambda: peer.received("HEARTBEAT"))
    own_server.kill()
    peer.state.received.clear()

    own_server.begin()
    wait_for("it hears the server again", lambda: peer.received("HEARTBEAT"), 60)
    assert not own_server.is_up()
    wait_for("the pages are there", own_server.is_up, 60)
    again = Api(own_server.address, own_server.local_key())
    assert [drone["link"]["state"] for drone in again.drones()] == ["live"]
    peer.close()


def _watch(port: int, on_cloud_loss: str) -> None:
    """In the dead server's place: listens until the vehicle passed two items, or gave its mission up."""
    link: Any = mavutil.mavlink_connection(f"udpin:127.0.0.1:{port}", source_system=254)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        heard = link.recv_match(type=["MISSION_CURRENT", "HEARTBEAT"], blocking=True, timeout=30)
        assert heard is not None, "the vehicle is silent"
        passed_two = heard.get_type() == "MISSION_CURRENT" and heard.seq >= HOME_ITEM + FIRST_WAYPOINT + 2
        returns = heard.get_type() == "HEARTBEAT" and heard.custom_mode == COPTER_RTL
        if passed_two if on_cloud_loss == "continue" else returns:
            link.close()
            return
    raise AssertionError("the vehicle did not do what its fail-safe says")


def _live(api: Api, drone: str) -> Json | None:
    now = api.drone(drone)
    return now if now["link"]["state"] == "live" else None


def _texts(api: Api, drone: Json) -> list[str]:
    return [message["text"] for message in api.drone(drone["id"])["messages"]]


def _with_mission(api: Api, drone: str) -> Json | None:
    """It may have landed by now, and then heads for no item."""
    now = api.drone(drone)
    return now if now["mission"]["items"] else None


def _replace_mission(port: int, home: Json) -> None:
    """Takes the dead server's place on its port and uploads another mission with pymavlink."""
    link: Any = mavutil.mavlink_connection(f"udpin:127.0.0.1:{port}", source_system=254)
    link.wait_heartbeat(timeout=30)
    waypoints = [(home["latitude"], home["longitude"]), *[(home["latitude"] + 2e-4, home["longitude"])] * 2]
    link.mav.mission_count_send(link.target_system, 1, len(waypoints))
    while True:
        asked = link.recv_match(
            type=["MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ACK"], blocking=True, timeout=30
        )
        assert asked is not None, "the vehicle took no mission"
        if asked.get_type() == "MISSION_ACK":
            break
        latitude, longitude = waypoints[asked.seq]
        link.mav.mission_item_int_send(
            *(link.target_system, 1, asked.seq, 3, 16, 0, 1, 0, 0, 0, 0),
            *(int(latitude * 1e7), int(longitude * 1e7), 12),
        )
    link.close()
