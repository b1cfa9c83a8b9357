"""The server killed with -9: vehicles hear it before its pages are there, and soon all is shown again."""

import secrets
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page
from pymavlink import mavutil

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import items, triangle
from dronemap_e2e.peer import Peer, with_hardware
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.stopwatch import Stopwatch
from dronemap_e2e.waiting import wait_for

# So soon after a restart all is shown again.
RETURN_SECONDS = 15


@pytest.fixture
def shipped(tmp_path: Path) -> Iterator[Server]:
    """As shipped: the second compiler takes as long again to start."""
    started = Server(tmp_path / "data", as_shipped=True)
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
def page(browser: Browser) -> Iterator[Page]:
    opened = open_page(browser)
    yield opened
    opened.context.close()


def signed_in(page: Page, server: Server, api: Api, drone: Json) -> Station:
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


def test_after_a_crash_a_mission_of_somebody_else_is_noticed(
    own_server: Server, in_mission: tuple[Api, Json], page: Page
) -> None:
    """End to end because an open page comes back by itself, and pymavlink takes the dead server's place."""
    api, drone = in_mission
    station = signed_in(page, own_server, api, drone)
    api.do(drone["id"], type="startMission")
    own_server.kill()
    _replace_mission(own_server.udp_port, drone["home"])

    again, watch = restart(own_server)
    now = wait_for("its mission was read", lambda: _with_mission(again, drone["id"]), 60)

    station.shows("2 items instead of 4", 60)
    watch.expect_at_most(RETURN_SECONDS)
    assert len(now["mission"]["items"]) == 2
    assert "2 items instead of 4" in now["mission"]["notice"]


def test_after_a_crash_vehicles_hear_the_server_before_its_pages_are_there(shipped: Server) -> None:
    """Pages take most of a start; ArduPilot flies home when it hears nothing for five seconds.

    End to end because it is about how long each part of a process takes to start.
    """
    api = Api(shipped.address, shipped.local_key())
    peer = Peer(shipped.udp_port, system_id=7, handlers={"COMMAND_LONG": with_hardware(0x5107)})
    wait_for("it is known", lambda: len(api.drones()) == 1)
    wait_for("it hears the server", lambda: peer.received("HEARTBEAT"))
    shipped.kill()
    peer.state.received.clear()

    watch = Stopwatch()
    shipped.begin()
    wait_for("it hears the server again", lambda: peer.received("HEARTBEAT"), 60)
    assert not shipped.is_up()
    wait_for("the pages are there", shipped.is_up, 60)
    again = Api(shipped.address, shipped.local_key())
    assert [drone["link"]["state"] for drone in again.drones()] == ["live"]
    watch.expect_at_most(RETURN_SECONDS)
    peer.close()


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
