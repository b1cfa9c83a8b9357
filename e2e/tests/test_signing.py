"""Signed links, with pymavlink's own implementation of signing as the vehicle."""

from collections.abc import Iterator

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import SigningPeer
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS


@pytest.fixture
def peer(server: Server) -> Iterator[SigningPeer]:
    started = SigningPeer(server.udp_port, next(SYSTEM_IDS))
    yield started
    started.close()


def listed(api: Api, peer: SigningPeer) -> str:
    """The id of the drone that the server made of this peer."""

    def find() -> str | None:
        found = [d for d in api.drones() if d["link"]["port"] == peer.port and d["link"]["state"] == "live"]
        return str(found[0]["id"]) if found else None

    return wait_for("the peer is listed", find, 20)


def test_pymavlink_and_server_accept_each_others_signatures(api: Api, peer: SigningPeer) -> None:
    """A key is made, put on the vehicle, changed and taken off it again; with each the vehicle is commanded.

    End to end because only another implementation of signing shows that ours means the same.
    """
    drone = listed(api, peer)
    path = f"/drones/{drone}"
    made = api.call("POST", f"{path}/link-key", {})
    assert made.status_code == 201, made.text
    installed = api.call("POST", f"{path}/link-key/install")
    assert installed.status_code == 200 and installed.json()["key"]["inUse"], installed.text
    required = api.call("PUT", f"{path}/link-security", {"policy": "required"})
    assert required.status_code == 200, required.text
    assert peer.keys == [bytes.fromhex(made.json()["key"])]

    api.do(drone, type="arm")
    assert peer.state.armed
    wait_for("what the server sends is signed", lambda: peer.link.signing.goodsig_count > 5)

    rotated = api.call("POST", f"{path}/link-key/rotate")
    assert rotated.status_code == 200 and rotated.json()["key"]["inUse"], rotated.text
    assert rotated.json()["key"]["fingerprint"] != made.json()["fingerprint"]
    api.do(drone, type="disarm")
    assert not peer.state.armed
    counts = api.get(f"{path}/link-security")["messages"]
    assert counts["valid"] > 5
    assert [counts[k] for k in ("unsigned", "badSignature", "replayed", "tooOld")] == [0, 0, 0, 0]
    assert peer.refused() == 0

    revoked = api.call("DELETE", f"{path}/link-key")
    assert revoked.status_code == 200, revoked.text
    assert revoked.json()["policy"] == "off" and revoked.json()["key"] is None
    assert peer.keys[-1] == bytes(32) and len(peer.keys) == 3
    api.do(drone, type="arm")
