"""The server killed with -9: heartbeats come before its pages are there, and soon all is shown again."""

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect
from pymavlink import mavutil

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import items, triangle
from dronemap_e2e.peer import Peer, reporting_hardware
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.station import Pointer, Station
from dronemap_e2e.stopwatch import Stopwatch
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

# So soon after a restart all is shown again.
RETURN_SECONDS = 15


@pytest.fixture
def shipped(tmp_path: Path) -> Iterator[Server]:
    """A server with its options as shipped, whose start takes longer."""
    started = Server(tmp_path / "data", as_shipped=True)
    started.start()
    yield started
    started.stop()


@pytest.fixture
def copter_in_mission(killable_server: Server, tmp_path: Path) -> Iterator[tuple[Api, Json]]:
    """A copter that has just begun a mission of three waypoints."""
    system_id = next(SYSTEM_IDS)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{killable_server.udp_port}",
        *("--count", "1", "--sysid", str(system_id)),
        *QUICK_FLIGHT,
    )
    api = Api(killable_server.address, killable_server.local_key())
    drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)
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


def sign_in(page: Page, server: Server, api: Api, drone: Json) -> Station:
    """Signed in before the crash, with the drone's panel open."""
    name = f"pilot-{secrets.token_hex(4)}"
    pilot = {"name": name, "password": secrets.token_hex(10), "role": "operator"}
    assert api.call("POST", "/users", pilot).status_code == 201
    station = Station(page, Pointer())
    station.sign_in(server.address, name, pilot["password"], secrets.token_hex(10))
    station.choose(drone["name"])
    return station


def test_mission_replaced_during_crash_is_noticed(
    killable_server: Server, copter_in_mission: tuple[Api, Json], page: Page
) -> None:
    """End to end because an open page comes back by itself, and pymavlink takes the dead server's place."""
    api, drone = copter_in_mission
    station = sign_in(page, killable_server, api, drone)
    api.do(drone["id"], type="startMission")
    killable_server.kill()
    _replace_mission(killable_server.udp_port, drone["home"])

    killable_server.start()
    again = Api(killable_server.address, killable_server.local_key())
    now = wait_for("its mission was read", lambda: _with_mission(again, drone["id"]), 60)

    station.shows("2 items instead of 4", 60)
    assert len(now["mission"]["items"]) == 2
    assert "2 items instead of 4" in now["mission"]["notice"]


def test_vehicles_get_heartbeats_before_pages_after_a_crash(killable_server: Server) -> None:
    """Pages take most of a start; ArduPilot flies home when it hears nothing for five seconds.

    End to end because it is about the order in which the parts of a process start.
    """
    with known_peer(killable_server) as peer:
        killable_server.kill()
        assert_link_before_pages(killable_server, peer)


@pytest.mark.soak
def test_state_is_shown_again_in_time_after_a_crash(shipped: Server, page: Page) -> None:
    with known_peer(shipped) as peer:
        api = Api(shipped.address, shipped.local_key())
        station = sign_in(page, shipped, api, listed(api, peer))
        shipped.kill()
        station.shows("No connection to the cloud")
        watch = Stopwatch()
        assert_link_before_pages(shipped, peer)
        expect(page.get_by_text("No connection to the cloud")).to_have_count(0, timeout=60_000)
        station.shows("Live", 60)
        watch.expect_at_most(RETURN_SECONDS)


@contextmanager
def known_peer(server: Server) -> Iterator[Peer]:
    """One that the server lists, and that hears it."""
    api = Api(server.address, server.local_key())
    peer = Peer(server.udp_port, system_id=7, handlers={"COMMAND_LONG": reporting_hardware(0x5107)})
    try:
        wait_for("it is live", lambda: [d["link"]["state"] for d in of(api, peer)] == ["live"])
        wait_for("it hears the server", lambda: peer.received("HEARTBEAT"))
        yield peer
    finally:
        peer.close()


def of(api: Api, peer: Peer) -> list[Json]:
    return [drone for drone in api.drones() if drone["link"]["port"] == peer.port]


def listed(api: Api, peer: Peer) -> Json:
    (drone,) = of(api, peer)
    return drone


def assert_link_before_pages(server: Server, peer: Peer) -> None:
    """From its end on until it is up again."""
    peer.state.received.clear()
    server.begin()
    wait_for("it hears the server again", lambda: peer.received("HEARTBEAT"), 60)
    assert not server.is_up()
    wait_for("the pages are there", server.is_up, 60)
    again = Api(server.address, server.local_key())
    assert [drone["link"]["state"] for drone in of(again, peer)] == ["live"]


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
