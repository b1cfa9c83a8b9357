"""What the server makes of vehicles that deny, stay silent, lose acknowledgements, or look alike."""

import json
import secrets
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from websockets.sync.client import connect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.peer import OBEDIENT, Handler, Kind, Peer, obey
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.stopwatch import Stopwatch
from dronemap_e2e.waiting import wait_for

MakePeer = Callable[..., Peer]


@pytest.fixture
def make_peer(server: Server) -> Iterator[MakePeer]:
    peers: list[Peer] = []

    def make(handlers: dict[str, Handler] | None = None, **options: Any) -> Peer:
        port = server.tcp_port if options.get("tcp") else server.udp_port
        peers.append(Peer(port, handlers=OBEDIENT if handlers is None else handlers, **options))
        return peers[-1]

    yield make
    for peer in peers:
        peer.close()


def listed(api: Api, peer: Peer) -> Json:
    """The drone that the server made of this peer."""

    def find() -> Json | None:
        found = [d for d in api.drones() if d["link"]["port"] == peer.port and d["link"]["state"] == "live"]
        return found[0] if found else None

    return wait_for("the peer is listed", find, 20)


def arm_commands(peer: Peer) -> list[Any]:
    return peer.commands(mavlink.MAV_CMD_COMPONENT_ARM_DISARM)


def test_the_vehicles_own_sentence_reaches_every_face(server: Server, api: Api, make_peer: MakePeer) -> None:
    sentence = f"PreArm: {secrets.token_hex(8)} not healthy"

    def deny(peer: Peer, message: Any) -> None:
        if message.command == mavlink.MAV_CMD_COMPONENT_ARM_DISARM:
            peer.say(sentence)
            peer.acknowledge(message, mavlink.MAV_RESULT_FAILED)

    drone = listed(api, make_peer({"COMMAND_LONG": deny}))["id"]
    headers = {"Authorization": f"Bearer {server.local_key()}"}
    with connect(server.stream_address, additional_headers=headers) as stream:
        record = api.command(drone, {"type": "arm"})
        assert record["outcome"] == {"result": "refused", "by": "vehicle", "reason": sentence}
        streamed = wait_for("the stream says so", lambda: _outcome(json.loads(stream.recv(10)), record["id"]))
        assert streamed["reason"] == sentence
    service = soap(server, server.local_key())
    outcome = service.arm(drone)
    assert (outcome.result, outcome.reason) == ("refused", sentence)
    assert sentence in [m["text"] for m in api.drone(drone)["messages"]]


def _outcome(message: Json, command: str) -> Json | None:
    if message["type"] != "command" or message["command"]["id"] != command:
        return None
    outcome: Json | None = message["command"]["outcome"]
    return outcome


def test_a_vehicle_that_never_answers_times_out_as_stated(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer({})
    drone = listed(api, peer)["id"]
    watch = Stopwatch()

    record = api.command(drone, {"type": "arm"})

    assert record["outcome"]["result"] == "timedOut", record
    stated = [float(word) for word in record["outcome"]["reason"].split() if word.replace(".", "").isdigit()]
    assert stated, record["outcome"]["reason"]
    watch.expect_at_most(stated[0] + 1)
    assert len(arm_commands(peer)) >= 5
    assert [int(m.confirmation) for m in arm_commands(peer)] == list(range(len(arm_commands(peer))))


def test_lost_acknowledgements_do_not_fail_what_was_done(api: Api, make_peer: MakePeer) -> None:
    changes: list[bool] = []

    def lose_two(peer: Peer, message: Any) -> None:
        if message.command != mavlink.MAV_CMD_COMPONENT_ARM_DISARM:
            return
        if not peer.state.armed:
            changes.append(True)
            peer.state.armed = True
        if len(arm_commands(peer)) > 2:
            peer.acknowledge(message)

    peer = make_peer({"COMMAND_LONG": lose_two})

    record = api.command(listed(api, peer)["id"], {"type": "arm"})

    assert record["outcome"]["result"] == "succeeded", record
    assert changes == [True]


def test_the_same_command_id_acts_once(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone = listed(api, peer)["id"]
    body = {"type": "arm", "id": "once-" + secrets.token_hex(8)}

    first = api.command(drone, body)
    second = api.command(drone, body)

    assert first["outcome"]["result"] == "succeeded"
    assert second["id"] == first["id"] and second["outcome"] == first["outcome"]
    assert len(arm_commands(peer)) == 1


def test_two_vehicles_with_one_system_id_are_two_drones(api: Api, make_peer: MakePeer) -> None:
    one, other = make_peer(system_id=7), make_peer(system_id=7)
    first, second = listed(api, one), listed(api, other)
    assert first["id"] != second["id"]
    assert first["link"]["systemId"] == second["link"]["systemId"] == 7

    api.do(second["id"], type="arm")

    assert not arm_commands(one) and arm_commands(other)
    assert api.drone(first["id"])["armed"] is False
    assert api.drone(second["id"])["armed"] is True


@pytest.mark.parametrize(
    "kind",
    [
        Kind(mavlink.MAV_TYPE_GCS, mavlink.MAV_AUTOPILOT_INVALID, component=190),
        Kind(mavlink.MAV_TYPE_GIMBAL, mavlink.MAV_AUTOPILOT_INVALID, component=154),
        Kind(mavlink.MAV_TYPE_ADSB, mavlink.MAV_AUTOPILOT_INVALID, component=156),
        Kind(mavlink.MAV_TYPE_ONBOARD_CONTROLLER, mavlink.MAV_AUTOPILOT_INVALID, component=191),
    ],
    ids=["ground station", "gimbal", "ADS-B", "companion computer"],
)
def test_other_components_make_no_drone(api: Api, make_peer: MakePeer, kind: Kind) -> None:
    stranger = make_peer(kind=kind, system_id=99)
    listed(api, make_peer(system_id=98))

    assert stranger.port not in [d["link"]["port"] for d in api.drones()]


def test_a_silent_vehicle_is_lost_within_six_seconds_and_returns(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone = listed(api, peer)["id"]
    watch = Stopwatch()
    peer.silent = True

    wait_for("lost", lambda: api.drone(drone)["link"]["state"] == "lost", 60)

    watch.expect_at_most(6)
    refused = api.call("POST", f"/drones/{drone}/commands", {"type": "arm"})
    assert refused.status_code == 409
    assert "no contact" in refused.json()["detail"]
    peer.silent = False
    wait_for("back", lambda: api.drone(drone)["link"]["state"] == "live")


def test_a_vehicle_may_come_by_tcp_and_by_mavlink_1(api: Api, make_peer: MakePeer) -> None:
    for options in ({"tcp": True}, {"kind": Kind(version=1)}):
        peer = make_peer(**options)
        drone = listed(api, peer)
        api.do(drone["id"], type="arm")
        assert peer.state.armed
        assert drone["link"]["transport"] == ("tcp" if "tcp" in options else "udp")


def test_broken_bytes_disturb_nobody(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone = listed(api, peer)["id"]
    for _ in range(200):
        peer.write(b"\xfd\xff\x00\x00" + secrets.token_bytes(60))

    api.do(drone, type="arm")

    assert peer.state.armed


def test_obeys_only_what_it_knows(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer({"COMMAND_LONG": obey})
    drone = listed(api, peer)["id"]
    api.do(drone, type="arm")

    record = api.command(drone, {"type": "takeOff", "altitude": 10})

    assert record["outcome"]["result"] in ("refused", "failed", "timedOut"), record
    assert record["outcome"]["reason"]
