"""Signed links, with pymavlink's own implementation of signing as the vehicle."""

import secrets
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import SigningPeer, now_ticks, resigned
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

MakePeer = Callable[..., SigningPeer]


@pytest.fixture
def make_peer(server: Server) -> Iterator[MakePeer]:
    peers: list[SigningPeer] = []

    def make(**options: Any) -> SigningPeer:
        peers.append(SigningPeer(server.udp_port, next(SYSTEM_IDS), **options))
        return peers[-1]

    yield make
    for peer in peers:
        peer.close()


def listed(api: Api, peer: SigningPeer) -> str:
    """The id of the drone that the server made of this peer."""

    def find() -> str | None:
        found = [d for d in api.drones() if d["link"]["port"] == peer.port and d["link"]["state"] == "live"]
        return str(found[0]["id"]) if found else None

    return wait_for("the peer is listed", find, 20)


def security(api: Api, drone: str) -> Json:
    return api.get(f"/drones/{drone}/link-security")


def refused(api: Api, drone: str, why: str) -> int:
    return int(security(api, drone)["messages"][why])


def make_key(api: Api, drone: str) -> str:
    answer = api.call("POST", f"/drones/{drone}/link-key", {})
    assert answer.status_code == 201, answer.text
    key: str = answer.json()["key"]
    return key


def secured(api: Api, peer: SigningPeer) -> tuple[str, bytes]:
    """A drone whose vehicle signs and must, and its key."""
    drone = listed(api, peer)
    key = make_key(api, drone)
    answer = api.call("POST", f"/drones/{drone}/link-key/install")
    assert answer.status_code == 200, answer.text
    assert answer.json()["key"]["inUse"], answer.text
    answer = api.call("PUT", f"/drones/{drone}/link-security", {"policy": "required"})
    assert answer.status_code == 200, answer.text
    assert peer.keys == [bytes.fromhex(key)]
    return drone, bytes.fromhex(key)


def settled(api: Api, drone: str) -> int:
    """How many frames were valid, once no more come."""
    seen: list[int] = []

    def still() -> bool:
        seen.append(refused(api, drone, "valid"))
        return len(seen) > 3 and seen[-1] == seen[-4]

    wait_for("no more frames come", still, 10)
    return seen[-1]


def test_a_signed_vehicle_is_commanded_as_any_other(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, _ = secured(api, peer)

    api.do(drone, type="arm")

    assert peer.state.armed
    wait_for("what the server sends is signed", lambda: peer.link.signing.goodsig_count > 5)
    assert peer.refused() == 0


def test_unsigned_frames_do_not_move_a_drone_that_must_sign(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, _ = secured(api, peer)

    def stop_signing() -> None:
        peer.link.signing.sign_outgoing = False
        peer.state.armed = True

    peer.do(stop_signing)

    wait_for("the drone falls silent", lambda: api.drone(drone)["link"]["state"] == "lost", 20)
    assert refused(api, drone, "unsigned") > 5
    state = api.drone(drone)
    assert state["armed"] is False
    warnings = [m for m in state["messages"] if m["text"].startswith("Unsigned messages")]
    assert len(warnings) == 1, state["messages"]


def test_a_wrong_key_does_not_move_the_drone(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, key = secured(api, peer)
    ahead = now_ticks() + 3_600 * 100_000

    peer.do(lambda: peer.use_key(secrets.token_bytes(32), ahead))

    wait_for("the drone falls silent", lambda: api.drone(drone)["link"]["state"] == "lost", 20)
    assert refused(api, drone, "badSignature") > 5
    peer.do(lambda: peer.use_key(key, now_ticks() + 120 * 100_000))
    wait_for("with the right key it lives again", lambda: api.drone(drone)["link"]["state"] == "live", 10)


def test_a_replayed_frame_is_refused(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, _ = secured(api, peer)
    wait_for("some signed frames went out", lambda: peer.written[-1][2] & 1)
    recorded = peer.written[-1]

    for _ in range(3):
        peer.do(lambda: peer.write_raw(recorded))

    wait_for("the copies are counted", lambda: refused(api, drone, "replayed") == 3)


def test_a_new_link_may_be_a_minute_behind_and_no_more(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, key = secured(api, peer)
    wait_for("some signed frames went out", lambda: peer.written[-1][2] & 1)
    frame = peer.written[-1]
    reached = int.from_bytes(frame[-12:-6], "little")

    peer.silent = True
    before = settled(api, drone)
    peer.do(lambda: peer.write_raw(resigned(frame, key, reached - 61 * 100_000, 77)))
    wait_for("the old one is refused", lambda: refused(api, drone, "tooOld") == 1)
    peer.do(lambda: peer.write_raw(resigned(frame, key, reached - 30 * 100_000, 77)))
    wait_for("the fresher one is taken", lambda: refused(api, drone, "valid") == before + 1)
    peer.do(lambda: peer.write_raw(resigned(frame, key, reached - 31 * 100_000, 77)))
    wait_for("and nothing before it", lambda: refused(api, drone, "replayed") == 1)


def test_a_rotation_in_flight_loses_no_frame(server: Server, api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, key = secured(api, peer)
    api.do(drone, type="arm")
    peer.silent = True
    valid_before = settled(api, drone)
    sent_before = peer.sent
    fingerprint = security(api, drone)["key"]["fingerprint"]
    peer.streaming = True
    peer.silent = False
    wait_for("the vehicle streams", lambda: peer.sent > sent_before + 50)

    # The vehicle reads with the new key at once, and the server hears of it late.
    peer.slow_seconds = 0.8
    with ThreadPoolExecutor() as beside:
        rotation = beside.submit(api.call, "POST", f"/drones/{drone}/link-key/rotate")
        wait_for("the vehicle has the new key", lambda: len(peer.keys) == 2, every=0.01)
        disarm = Api(server.address, server.local_key()).command(drone, {"type": "disarm"})
        answer = rotation.result()

    assert answer.status_code == 200, answer.text
    assert answer.json()["key"]["inUse"] and answer.json()["key"]["fingerprint"] != fingerprint
    assert disarm["outcome"]["result"] == "succeeded", disarm
    wait_for("it goes on streaming", lambda: peer.sent > sent_before + 300)
    peer.silent = True
    valid_after = settled(api, drone)
    assert valid_after - valid_before == peer.sent - sent_before
    counts = security(api, drone)["messages"]
    assert [counts[k] for k in ("unsigned", "badSignature", "replayed", "tooOld")] == [0, 0, 0, 0]
    assert peer.keys[-1] != key and len(peer.keys) == 2
    assert peer.refused() == 0
    assert peer.gaps() == 0


def test_a_rotation_that_the_vehicle_ignores_keeps_the_old_key(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, _ = secured(api, peer)
    before = security(api, drone)["key"]
    peer.takes_keys = False

    answer = api.call("POST", f"/drones/{drone}/link-key/rotate")

    assert answer.status_code == 409, answer.text
    assert "goes on as before" in answer.json()["detail"]
    after = security(api, drone)
    assert after["key"] == before and after["nextKey"] is None
    api.do(drone, type="arm")


def test_a_revoked_key_is_taken_off_the_vehicle(api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, _ = secured(api, peer)

    answer = api.call("DELETE", f"/drones/{drone}/link-key")

    assert answer.status_code == 200, answer.text
    assert answer.json()["policy"] == "off" and answer.json()["key"] is None
    assert peer.keys[-1] == bytes(32)
    api.do(drone, type="arm")


def test_required_is_refused_for_a_vehicle_that_never_signed(api: Api, make_peer: MakePeer) -> None:
    drone = listed(api, make_peer())
    make_key(api, drone)

    answer = api.call("PUT", f"/drones/{drone}/link-security", {"policy": "required"})

    assert answer.status_code == 409
    assert "never heard to sign" in answer.json()["detail"]


def test_a_key_is_never_told_to_others(server: Server, api: Api, make_peer: MakePeer) -> None:
    peer = make_peer()
    drone, key = secured(api, peer)
    told = [
        api.call("GET", path).text
        for path in ("/drones", f"/drones/{drone}", f"/drones/{drone}/link-security")
    ]
    log = (server.data / "server.log").read_text(errors="replace")
    for text in [*told, log]:
        assert key.hex() not in text.lower()
    assert (server.data / "link-secret").stat().st_mode & 0o777 == 0o600
    assert server.local_key() not in log


def test_a_simulated_copter_installs_flies_and_refuses_a_new_key_when_armed(api: Api, copter: Json) -> None:
    drone = copter["id"]
    make_key(api, drone)
    answer = api.call("POST", f"/drones/{drone}/link-key/install")
    assert answer.status_code == 200, answer.text
    assert api.call("PUT", f"/drones/{drone}/link-security", {"policy": "required"}).ok

    api.do(drone, type="arm")
    api.do(drone, type="takeOff", altitude=8)
    answer = api.call("POST", f"/drones/{drone}/link-key/rotate")

    assert answer.status_code == 409
    assert "armed" in answer.json()["detail"], answer.text
    api.do(drone, type="land")
    counts = security(api, drone)["messages"]
    assert counts["valid"] > 30
    assert sum(counts.values()) == counts["valid"], counts


def test_the_key_and_its_time_outlive_a_crash(tmp_path: Path) -> None:
    started = Server(tmp_path / "data")
    started.start()
    simulator = Simulator(
        tmp_path / "sim.log", f"udp://127.0.0.1:{started.udp_port}", "--personality", "px4", "--sysid", "9"
    )
    try:
        api = Api(started.address, started.local_key())
        drone = wait_for("the vehicle is listed", lambda: next((d["id"] for d in api.drones()), None), 30)
        make_key(api, drone)
        assert api.call("POST", f"/drones/{drone}/link-key/install").status_code == 200
        assert api.call("PUT", f"/drones/{drone}/link-security", {"policy": "required"}).ok
        fingerprint = security(api, drone)["key"]["fingerprint"]

        started.kill()
        started.start()
        api = Api(started.address, started.local_key())

        wait_for("the vehicle lives again", lambda: api.drone(drone)["link"]["state"] == "live", 30)
        after = security(api, drone)
        assert after["policy"] == "required"
        assert after["key"] == {"fingerprint": fingerprint, "inUse": True}
        assert after["messages"]["unsigned"] == 0
        rotated = api.call("POST", f"/drones/{drone}/link-key/rotate")
        assert rotated.status_code == 200, rotated.text
    finally:
        simulator.stop()
        started.stop()
