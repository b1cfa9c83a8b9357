"""Who speaks for which drone: addresses that change, forgers, and strangers that wait."""

import secrets
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.peer import OBEDIENT, Peer, with_hardware
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import SigningPeer
from dronemap_e2e.waiting import rounds, throughout, wait_for

from .conftest import SYSTEM_IDS

ARM = mavlink.MAV_CMD_COMPONENT_ARM_DISARM
MakePeer = Callable[..., Peer]

# A new address is believed once the old one has been silent for 1.5 s; until then commands go to the old one.
LATEST_TO_AN_OLD_ADDRESS = 4.0
QUESTIONS = (mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES)


@pytest.fixture
def make_peer() -> Iterator[MakePeer]:
    peers: list[Peer] = []

    def make(server: Server, uid: int | None, system_id: int | None = None, tcp: bool = False) -> Peer:
        handlers = OBEDIENT if uid is None else {**OBEDIENT, "COMMAND_LONG": with_hardware(uid)}
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


def the_live_one(api: Api, peer: Peer) -> Json:
    def find() -> Json | None:
        found = [d for d in drones_of(api, peer.link.srcSystem) if d["link"]["state"] == "live"]
        return found[0] if found else None

    return wait_for("the peer is listed", find, 20)


def told_to_act(messages: list[Any]) -> list[Any]:
    """What went to a peer beyond the question who it is."""
    return [m for m in messages if m.get_type() != "COMMAND_LONG" or m.command not in QUESTIONS]


def fly_from_place_to_place(api: Api, peer: Peer, seconds: float, every: float) -> None:
    drone = the_live_one(api, peer)["id"]
    left: list[Peer.Forwarding] = []
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
        assert not told_to_act(too_late), too_late


def test_a_vehicle_that_changes_its_address_keeps_its_drone(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    fly_from_place_to_place(api, make_peer(server, new_uid()), seconds=32, every=10)


@pytest.mark.soak
def test_a_vehicle_changes_its_address_for_two_minutes(server: Server, api: Api, make_peer: MakePeer) -> None:
    fly_from_place_to_place(api, make_peer(server, new_uid()), seconds=120, every=10)


def test_a_forged_vehicle_moves_nothing_and_is_told_nothing(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    uid = new_uid()
    real = make_peer(server, uid)
    drone = the_live_one(api, real)["id"]
    wait_for("its hardware is known", lambda: api.drone(drone)["identity"]["hardwareId"], 10)
    real.link.global_position_int_send(0, 473977420, 85455940, 498000, 10000, 0, 0, 0, 0)
    wait_for("its position is known", lambda: api.drone(drone)["position"], 10)

    forger = make_peer(server, uid, real.link.srcSystem)
    for _ in rounds(time.monotonic() + 8, 0.1):
        forger.link.global_position_int_send(0, 100000000, 100000000, 498000, 10000, 0, 0, 0, 0)
        forger.link.autopilot_version_send(0, 0, 0, 0, 0, bytes(8), bytes(8), bytes(8), 0, 0, uid)
        listed = drones_of(api, real.link.srcSystem)
        assert [d["id"] for d in listed] == [drone]
        assert listed[0]["link"]["port"] == real.port
        assert abs(listed[0]["position"]["latitude"] - 47.397742) < 1e-6

    waiting = [w for w in api.get("/waiting")["waiting"] if w["port"] == forger.port]
    assert [(w["reason"], w["claims"]) for w in waiting] == [("quarantined", drone)]
    assert any("quarantine" in m["text"] for m in api.drone(drone)["messages"])
    api.do(drone, type="arm")
    assert real.state.armed and not forger.state.armed
    assert not told_to_act(forger.state.received)

    real.silent = True
    wait_for("lost", lambda: api.drone(drone)["link"]["state"] == "lost", 8)
    assert api.drone(drone)["link"]["port"] == real.port
    assert not told_to_act(forger.state.received)


def test_two_vehicles_without_hardware_ids_and_one_system_id_stay_two(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    one = make_peer(server, None)
    make_peer(server, None, one.link.srcSystem)

    wait_for("both are listed", lambda: len(drones_of(api, one.link.srcSystem)) == 2, 10)


def test_a_silent_drone_that_has_shown_proof_is_not_given_to_less(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    uid = new_uid()
    real = SigningPeer(server.udp_port, next(SYSTEM_IDS), {"COMMAND_LONG": with_hardware(uid)})
    try:
        drone = the_live_one(api, real)["id"]
        sign(api, drone)
        wait_for("the proof counts", lambda: api.drone(drone)["identity"]["evidence"] == "signature", 20)
        real.silent = True
        wait_for("lost", lambda: api.drone(drone)["link"]["state"] == "lost", 20)

        forger = make_peer(server, uid, real.link.srcSystem)
        waiting = wait_for("it is in quarantine", lambda: waiting_at(api, forger.port), 20)

        assert (waiting["reason"], waiting["claims"]) == ("quarantined", drone)
        assert api.drone(drone)["link"]["state"] == "lost"
        assert [d["id"] for d in drones_of(api, real.link.srcSystem)] == [drone]
        assert not told_to_act(forger.state.received)
        real.silent = False
        wait_for("it is back", lambda: api.drone(drone)["link"]["state"] == "live", 20)
        api.do(drone, type="arm")
        assert real.state.armed
    finally:
        real.close()


def waiting_at(api: Api, port: int) -> Json | None:
    return next((w for w in api.get("/waiting")["waiting"] if w["port"] == port), None)


def sign(api: Api, drone: str) -> None:
    """Its vehicle gets a key and signs from now on."""
    assert api.call("POST", f"/drones/{drone}/link-key", {}).status_code == 201
    answer = api.call("POST", f"/drones/{drone}/link-key/install")
    assert answer.status_code == 200 and answer.json()["key"]["inUse"], answer.text


def at_port(api: Api, peer: Peer) -> str:
    """The id of the drone that is heard from the address of that peer."""

    def find() -> str | None:
        found = [d for d in drones_of(api, peer.link.srcSystem) if d["link"]["port"] == peer.port]
        return str(found[0]["id"]) if found else None

    return wait_for("the peer is listed", find, 30)


def knows_hardware(api: Api, drone: str) -> None:
    wait_for("its hardware is known", lambda: api.drone(drone)["identity"]["hardwareId"], 20)


def each_keeps_its_own(api: Api, one: Peer, other: Peer) -> None:
    """Two vehicles with one system id: two drones, also when both change their address at the same time."""
    first, second = at_port(api, one), at_port(api, other)
    assert first != second
    left = []
    try:
        for _ in range(2):
            for peer, drone, armed in ((one, first, True), (other, second, True), (one, first, False)):
                api.do(drone, type="arm" if armed else "disarm")
                assert peer.state.armed is armed
            api.do(second, type="disarm")
            left += [one.move(), other.move()]
            wait_for("both have their drones", lambda: at_port(api, one) == first, 30)
            wait_for("both have their drones", lambda: at_port(api, other) == second, 30)
        listed = {d["id"] for d in drones_of(api, one.link.srcSystem)}
        assert listed == {first, second}
        assert len(one.commands(ARM)) >= 4 and len(other.commands(ARM)) >= 4
    finally:
        for place in left:
            place.close()


def test_two_vehicles_of_one_system_id_are_told_apart_by_their_hardware(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    one = make_peer(server, new_uid())
    other = make_peer(server, new_uid(), one.link.srcSystem)
    for peer in (one, other):
        knows_hardware(api, at_port(api, peer))

    each_keeps_its_own(api, one, other)


def test_two_vehicles_of_one_system_id_are_told_apart_by_their_signatures(server: Server, api: Api) -> None:
    one = SigningPeer(server.udp_port, next(SYSTEM_IDS))
    other = SigningPeer(server.udp_port, one.link.srcSystem)
    try:
        for peer in (one, other):
            sign(api, at_port(api, peer))
        each_keeps_its_own(api, one, other)
    finally:
        one.close()
        other.close()


def test_a_command_right_after_a_tcp_connection_came_back_is_carried_out(
    server: Server, api: Api, make_peer: MakePeer
) -> None:
    peer = make_peer(server, new_uid(), tcp=True)
    drone = the_live_one(api, peer)["id"]
    knows_hardware(api, drone)

    for armed in (True, False, True, False):
        peer.reconnect()
        record = api.do(drone, type="arm" if armed else "disarm")
        assert peer.state.armed is armed, record

    assert [d["id"] for d in drones_of(api, peer.link.srcSystem)] == [drone]


def test_a_stranger_waits_until_an_administrator_lets_it_in(tmp_path: Path, make_peer: MakePeer) -> None:
    server = Server(tmp_path / "data", DRONEMAP_ENROLMENT="nowhere")
    server.start()
    try:
        api = Api(server.address, server.local_key())
        stranger = make_peer(server, new_uid())

        waiting = wait_for("it waits", lambda: api.get("/waiting")["waiting"], 10)[0]
        assert (waiting["reason"], waiting["port"]) == ("unknown", stranger.port)
        throughout("it is no drone", lambda: api.drones() == [], 3)
        assert stranger.received("COMMAND_LONG") and not told_to_act(stranger.state.received)
        viewer = Api(server.address, api.new_key("eyes", "viewer"))
        assert viewer.call("GET", "/waiting").status_code == 403
        assert api.call("POST", "/waiting/nobody/enrol", {}).status_code == 404

        drone = api.call("POST", f"/waiting/{waiting['id']}/enrol", {"name": "Rescue 7"})
        assert drone.status_code == 201 and drone.json()["name"] == "Rescue 7"
        wait_for("it is live", lambda: the_live_one(api, stranger), 10)
        api.do(drone.json()["id"], type="arm")
        assert stranger.state.armed
        assert api.get("/waiting")["waiting"] == []

        # Known again after a restart, without anybody letting it in.
        server.kill()
        server.start()
        assert the_live_one(Api(server.address, server.local_key()), stranger)["name"] == "Rescue 7"
    finally:
        server.stop()
