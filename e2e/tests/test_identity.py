"""A vehicle whose address changes for a long time."""

import secrets
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.peer import STANDARD_HANDLERS, Peer, reporting_hardware
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import rounds, wait_for

from .conftest import SYSTEM_IDS

MakePeer = Callable[..., Peer]

# A new address is believed once the old one has been silent for 1.5 s; until then commands go to the old one.
LATEST_TO_AN_OLD_ADDRESS = 4.0
QUESTIONS = (mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES)


@pytest.fixture
def make_peer() -> Iterator[MakePeer]:
    peers: list[Peer] = []

    def make(server: Server, uid: int | None, system_id: int | None = None, tcp: bool = False) -> Peer:
        handlers = (
            STANDARD_HANDLERS
            if uid is None
            else {**STANDARD_HANDLERS, "COMMAND_LONG": reporting_hardware(uid)}
        )
        port = server.tcp_port if tcp else server.udp_port
        peers.append(Peer(port, system_id=system_id or next(SYSTEM_IDS), handlers=handlers, tcp=tcp))
        return peers[-1]

    yield make
    for peer in peers:
        peer.close()


def new_uid() -> int:
    return secrets.randbits(63) | 1


def drones_of(api: Api, system_id: int) -> list[Json]:
    return [d for d in api.drones() if d["link"]["systemId"] == system_id]


def live_drone(api: Api, peer: Peer) -> Json:
    def find() -> Json | None:
        found = [d for d in drones_of(api, peer.link.srcSystem) if d["link"]["state"] == "live"]
        return found[0] if found else None

    return wait_for("the peer is listed", find, 20)


def action_commands(messages: list[Any]) -> list[Any]:
    """Messages to a peer other than requests for its identity."""
    return [m for m in messages if m.get_type() != "COMMAND_LONG" or m.command not in QUESTIONS]


def move_and_arm(api: Api, peer: Peer, seconds: float, every: float) -> None:
    drone = live_drone(api, peer)["id"]
    left: list[Peer.FormerAddress] = []
    try:
        end = time.monotonic() + seconds
        next_move = time.monotonic() + 1
        arm = True
        for _ in rounds(end, 0.2):
            if time.monotonic() >= next_move:
                left.append(peer.move())
                next_move += every
            record = api.command(drone, {"type": "arm" if arm else "disarm"})
            assert record["outcome"]["result"] == "succeeded", record
            assert peer.state.armed is arm
            arm = not arm
            listed = drones_of(api, peer.link.srcSystem)
            assert [d["id"] for d in listed] == [drone]
            assert listed[0]["link"]["state"] != "lost"
        assert api.drone(drone)["link"]["port"] == peer.port
    finally:
        for place in left:
            place.close()
    assert len(left) >= 2
    for place in left:
        too_late = [m for when, m in place.late if when > LATEST_TO_AN_OLD_ADDRESS]
        assert not action_commands(too_late), too_late


@pytest.mark.soak
def test_vehicle_stays_one_drone_while_its_address_changes(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    move_and_arm(api, make_peer(server, new_uid()), seconds=120, every=10)
