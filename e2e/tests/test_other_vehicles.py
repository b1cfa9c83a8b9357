"""The same flight with a PX4 made of pymavlink, over TCP, and with a real autopilot where one is given."""

from functools import partial
from pathlib import Path
from typing import Any

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import items, triangle
from dronemap_e2e.message_recorder import MessageRecorder
from dronemap_e2e.peer import STANDARD_HANDLERS, Kind, Peer
from dronemap_e2e.px4_peer import Px4Peer
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.waiting import wait_for

HEIGHT = 8.0
NAV_TAKEOFF = 22
DO_REPOSITION = 192


def fly(api: Api, drone: Json, patience: float = 1.0) -> None:
    """Arm, take off, go somewhere, fly a mission, come home; watched through REST."""
    identity = drone["id"]

    def do(kind: str, **body: Any) -> None:
        api.do(identity, type=kind, **body)

    def above_home() -> float:
        return float(api.drone(identity)["position"]["altitudeAboveHome"] or 0)

    points = triangle(drone["home"], HEIGHT, 20)
    do("arm")
    do("takeOff", altitude=HEIGHT)
    wait_for("it hovers", lambda: above_home() > HEIGHT - 1, 60 * patience)
    first = points[0]
    do("goTo", latitude=first.latitude, longitude=first.longitude, altitude=HEIGHT)

    def metres_away() -> float:
        position = api.drone(identity)["position"]
        return first.metres_to(position["latitude"], position["longitude"])

    wait_for("it is where it was told to go", lambda: metres_away() < 2, 60 * patience)
    do("uploadMission", items=items(points))
    do("startMission")
    last = len(api.drone(identity)["mission"]["items"]) - 1
    wait_for(
        "the last item is reached", lambda: last in api.drone(identity)["mission"]["reached"], 120 * patience
    )
    # Not every vehicle says it: MAVLink 1 has no field for it.
    wait_for("the mission is over", lambda: api.drone(identity)["mission"]["state"] in ("complete", None))
    assert last in api.drone(identity)["mission"]["reached"], "what was reached stays so"
    do("hold")
    do("returnToLaunch")
    wait_for("it landed and disarmed", lambda: api.drone(identity)["armed"] is False, 150 * patience)
    assert above_home() < 1


def test_pymavlink_px4_flies_by_px4_commands(server: Server, api: Api) -> None:
    """End to end because the vehicle is made of pymavlink, by other hands than the simulator is."""
    px4 = Px4Peer(server.udp_port, system_id=154)
    try:
        drone = wait_for(
            "the peer is listed with a home",
            lambda: next((d for d in api.drones() if d["link"]["port"] == px4.peer.port and d["home"]), None),
        )
        assert drone["autopilot"] == "PX4"

        fly(api, drone)

        assert px4.peer.commands(NAV_TAKEOFF) and px4.peer.commands(DO_REPOSITION)
        assert not {NAV_TAKEOFF, DO_REPOSITION} & set(px4.refused)
    finally:
        px4.close()


def test_peer_by_tcp_and_mavlink_1(server: Server, api: Api) -> None:
    """End to end because pymavlink makes the frames of MAVLink 1, and another program's socket the pieces."""
    for tcp, version in ((True, 2), (False, 1)):
        port = server.tcp_port if tcp else server.udp_port
        peer = Peer(port, system_id=155, kind=Kind(version=version), handlers=STANDARD_HANDLERS, tcp=tcp)
        try:
            drone = wait_for("the peer is listed", partial(listed, api, peer))
            api.do(drone["id"], type="arm")
            assert peer.state.armed
            assert drone["link"]["transport"] == ("tcp" if tcp else "udp")
        finally:
            peer.close()


def listed(api: Api, peer: Peer) -> Json | None:
    found = (d for d in api.drones() if d["link"]["port"] == peer.port and d["link"]["state"] == "live")
    return next(found, None)


def test_flight_over_tcp(server: Server, api: Api, tmp_path: Path) -> None:
    """End to end because only sockets of two processes show that a stream of bytes carries a flight."""
    simulator = Simulator(
        tmp_path / "sim.log", f"tcp://127.0.0.1:{server.tcp_port}", "--sysid", "152", *QUICK_FLIGHT
    )
    try:
        drone = wait_for("it is ready", lambda: api.ready(152), 90)
        assert drone["link"]["transport"] == "tcp"
        fly(api, drone)
    finally:
        simulator.stop()


@pytest.mark.skipif(sitl.COPTER.binary is None, reason=sitl.COPTER.why_not)
def test_flight_with_real_autopilot(api: Api, recorder: MessageRecorder, tmp_path: Path) -> None:
    """End to end because ArduCopter itself flies."""
    autopilot = sitl.Autopilot(sitl.COPTER, tmp_path / "sitl", recorder.port, 153, "47.3977,8.5456,488,0")
    try:
        drone = wait_for("it is ready", lambda: api.ready(153), 120)
        wait_for("it may fly", lambda: sitl.arms_and_enters_guided(api, drone["id"]), 90, every=3)
        fly(api, drone, patience=3)
    finally:
        autopilot.close()
