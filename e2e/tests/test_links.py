"""A link that another program opens carries a flight, on an endpoint that was added at run time."""

import socket
from pathlib import Path

import pytest
import requests

from dronemap_e2e.api import Api, Json
from dronemap_e2e.dtls import DtlsClient, HandshakeError
from dronemap_e2e.frame_links import Bridge, OpenSslDtlsLink
from dronemap_e2e.ports import free_port
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

TAKE_OFF_METERS = 8.0


def fly(api: Api, drone: str) -> None:
    api.do(drone, type="arm")
    api.do(drone, type="takeOff", altitude=TAKE_OFF_METERS)
    wait_for("it hovers", lambda: _altitude(api, drone) > TAKE_OFF_METERS - 1, 60)
    home = api.drone(drone)["home"]
    north = home["latitude"] + 0.0002
    api.do(drone, type="goTo", latitude=north, longitude=home["longitude"], altitude=TAKE_OFF_METERS)
    wait_for("it is there", lambda: abs(api.drone(drone)["position"]["latitude"] - north) < 2e-5, 60)
    api.do(drone, type="land")
    wait_for("it landed and disarmed", lambda: api.drone(drone)["armed"] is False, 90)


def _altitude(api: Api, drone: str) -> float:
    altitude: float = api.drone(drone)["position"]["altitudeAboveHome"]
    return altitude


def test_flight_by_openssl_dtls_on_persistent_endpoint_and_key(
    killable_server: Server, tmp_path: Path
) -> None:
    """End to end because OpenSSL is another program, and a restart one of the process with its database."""
    api = Api(killable_server.address, killable_server.local_key())
    made = api.call("POST", "/dtls-keys", {"label": "OpenSSL copter"})
    assert made.status_code == 201, made.text
    key = made.json()
    port = free_port(socket.SOCK_DGRAM)
    url = f"dtlsserver://127.0.0.1:{port}"
    added = api.call("POST", "/endpoints", {"url": url})
    assert added.status_code == 201, added.text
    path = f"/endpoints/{added.json()['id']}"
    killable_server.stop()
    killable_server.start()

    api = Api(killable_server.address, killable_server.local_key())
    opened = api.get(path)
    assert (opened["url"], opened["state"], opened["origin"]) == (url, "open", "added")
    system_id = next(SYSTEM_IDS)
    bridge = Bridge(OpenSslDtlsLink(port, key["identity"], key["secret"], tmp_path / "openssl.log"))
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{bridge.port}",
        *("--count", "1", "--sysid", str(system_id)),
        *QUICK_FLIGHT,
    )
    try:
        drone = wait_for("the copter is ready to arm", lambda: api.ready(system_id), 90)
        fly(api, drone["id"])
        assert api.drone(drone["id"])["link"]["transport"] == "dtls"
        check_counters(killable_server, api, api.get(path), drone)
        assert [p["identity"] for p in api.get(path)["peers"]] == [key["identity"]]
    finally:
        simulator.stop()
        bridge.close()

    secret = bytes.fromhex(key["secret"])
    DtlsClient(("127.0.0.1", port), key["identity"], secret).close()
    assert api.call("DELETE", f"/dtls-keys/{key['identity']}").status_code == 204
    with pytest.raises(HandshakeError):
        DtlsClient(("127.0.0.1", port), key["identity"], secret, timeout=2)
    assert api.call("DELETE", path).status_code == 204


def check_counters(server: Server, api: Api, endpoint: Json, drone: Json) -> None:
    counts = endpoint["counts"]
    assert counts["framesIn"] > 100
    assert counts["framesOut"] > 10
    # The simulator greets as an autopilot does, with a line of text before the first frame.
    assert counts["brokenBytes"] < 100
    text = _metrics(server, api.new_key("monitoring", "viewer"))
    assert f'dronemap_endpoint_frames_in_total{{endpoint="{endpoint["id"]}"' in text
    assert f'dronemap_vehicle_received_total{{drone="{drone["id"]}"' in text
    assert requests.get(server.address + "/metrics", timeout=5).status_code == 401
    (udp,) = (
        e
        for e in api.get("/endpoints")["endpoints"]
        if e["url"] == f"udpserver://127.0.0.1:{server.udp_port}"
    )
    assert udp["origin"] == "configured"
    assert udp["counts"]["kernelDrops"] == 0
    (mine,) = (v for v in api.get("/traffic")["vehicles"] if v["drone"] == drone["id"])
    assert mine["received"] > 10
    assert mine["sent"] > 1


def _metrics(server: Server, key: str) -> str:
    headers = {"Authorization": f"Bearer {key}"}
    answer = requests.get(server.address + "/metrics", headers=headers, timeout=5)
    assert answer.ok, answer.text
    return answer.text
