"""Each kind of link carries one flight; endpoints come and go at run time and outlive the server."""

import contextlib
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
import requests

from dronemap_e2e.api import Api, Json
from dronemap_e2e.carriers import (
    Bridge,
    Carrier,
    Dtls,
    OpenSsl,
    SerialCable,
    TcpListener,
    UdpListener,
    WebSocketCaller,
    WebSocketListener,
)
from dronemap_e2e.dtls import DtlsClient, HandshakeError
from dronemap_e2e.ports import free_port
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

TAKE_OFF_METERS = 8.0


@contextlib.contextmanager
def endpoint(api: Api, url: str) -> Iterator[Json]:
    """An endpoint for the time of a test, once it is open."""
    answer = api.call("POST", "/endpoints", {"url": url})
    assert answer.status_code == 201, answer.text
    path = f"/endpoints/{answer.json()['id']}"
    try:
        yield wait_for(f"{url} is open", lambda: _open(api.get(path)), 20)
    finally:
        assert api.call("DELETE", path).status_code == 204


def _open(view: Json) -> Json | None:
    return view if view["state"] == "open" else None


@contextlib.contextmanager
def vehicle(api: Api, carrier: Carrier, log: Path) -> Iterator[tuple[Bridge, Json]]:
    """A simulated copter behind that link: the bridge, and the drone as the server lists it."""
    system_id = next(SYSTEM_IDS)
    bridge = Bridge(carrier)
    simulator = Simulator(
        log,
        f"udp://127.0.0.1:{bridge.port}",
        *("--count", "1", "--speedup", "4", "--sysid", str(system_id)),
    )
    try:
        yield bridge, wait_for("the copter is ready to arm", lambda: api.ready(system_id), 90)
    finally:
        simulator.stop()
        bridge.close()


def take_off(api: Api, drone: str) -> None:
    api.do(drone, type="arm")
    api.do(drone, type="takeOff", altitude=TAKE_OFF_METERS)
    wait_for("it hovers", lambda: _altitude(api, drone) > TAKE_OFF_METERS - 1, 60)


def go_and_land(api: Api, drone: str) -> None:
    home = api.drone(drone)["home"]
    north = home["latitude"] + 0.0002
    api.do(drone, type="goTo", latitude=north, longitude=home["longitude"], altitude=TAKE_OFF_METERS)
    wait_for("it is there", lambda: abs(api.drone(drone)["position"]["latitude"] - north) < 2e-5, 60)
    api.do(drone, type="land")
    wait_for("it landed and disarmed", lambda: api.drone(drone)["armed"] is False, 90)


def _altitude(api: Api, drone: str) -> float:
    altitude: float = api.drone(drone)["position"]["altitudeAboveHome"]
    return altitude


def fly(api: Api, drone: Json, transport: str) -> None:
    take_off(api, drone["id"])
    go_and_land(api, drone["id"])
    assert api.drone(drone["id"])["link"]["transport"] == transport


def test_flies_over_a_serial_line(api: Api, tmp_path: Path) -> None:
    cable = SerialCable()
    with (
        endpoint(api, f"serial://{cable.device}?baud=57600") as opened,
        vehicle(api, cable, tmp_path / "sim.log") as (_, drone),
    ):
        fly(api, drone, "serial")

        assert drone["link"]["address"] == cable.device
        assert drone["link"]["port"] == 0
        counts = api.get(f"/endpoints/{opened['id']}")["counts"]
        assert counts["framesIn"] > 100
        assert counts["framesOut"] > 10
        assert counts["lost"] == 0
        # The simulator greets as an autopilot does, with a line of text before the first frame.
        assert counts["brokenBytes"] < 100


def test_flies_over_a_udp_client(api: Api, tmp_path: Path) -> None:
    listener = UdpListener()
    with (
        endpoint(api, f"udpclient://127.0.0.1:{listener.port}"),
        vehicle(api, listener, tmp_path / "sim.log") as (_, drone),
    ):
        fly(api, drone, "udp")


def test_flies_over_a_tcp_client_that_connects_again(api: Api, tmp_path: Path) -> None:
    listener = TcpListener()
    with (
        endpoint(api, f"tcpclient://127.0.0.1:{listener.port}"),
        vehicle(api, listener, tmp_path / "sim.log") as (_, drone),
    ):
        take_off(api, drone["id"])
        listener.hang_up()
        # Given while there is no connection: it is sent again when there is one.
        api.do(drone["id"], type="hold")
        api.do(drone["id"], type="setMode", mode="GUIDED")
        go_and_land(api, drone["id"])
        assert api.drone(drone["id"])["link"]["transport"] == "tcp"


def test_flies_over_a_websocket_that_the_vehicle_opens(api: Api, tmp_path: Path) -> None:
    with (
        endpoint(api, "wsserver://127.0.0.1:0") as opened,
        vehicle(api, WebSocketCaller(_port(opened)), tmp_path / "sim.log") as (_, drone),
    ):
        fly(api, drone, "websocket")


def test_flies_over_a_websocket_that_the_server_opens(api: Api, tmp_path: Path) -> None:
    listener = WebSocketListener()
    with (
        endpoint(api, f"wsclient://127.0.0.1:{listener.port}/mavlink"),
        vehicle(api, listener, tmp_path / "sim.log") as (_, drone),
    ):
        fly(api, drone, "websocket")


def _port(view: Json) -> int:
    return int(view["url"].rsplit(":", 1)[1])


def test_flies_over_dtls_with_openssl(api: Api, tmp_path: Path) -> None:
    key = _key(api, "OpenSSL copter")
    with endpoint(api, "dtlsserver://127.0.0.1:0") as opened:
        carrier = OpenSsl(_port(opened), key["identity"], key["secret"], tmp_path / "openssl.log")
        with vehicle(api, carrier, tmp_path / "sim.log") as (_, drone):
            fly(api, drone, "dtls")

            peers = api.get(f"/endpoints/{opened['id']}")["peers"]
            assert [p["identity"] for p in peers] == [key["identity"]]


def test_an_address_change_in_flight_keeps_a_dtls_vehicle(api: Api, tmp_path: Path) -> None:
    key = _key(api, "roaming copter")
    with endpoint(api, "dtlsserver://127.0.0.1:0") as opened:
        carrier = Dtls(_port(opened), key["identity"], key["secret"])
        assert carrier.client.connection_id, "the server gave no connection id"
        with vehicle(api, carrier, tmp_path / "sim.log") as (_, drone):
            take_off(api, drone["id"])
            before = carrier.client.port
            for _ in range(3):
                carrier.client.rebind()
                api.do(drone["id"], type="hold")
                api.do(drone["id"], type="setMode", mode="GUIDED")
            go_and_land(api, drone["id"])

            assert carrier.client.port != before
            peers = api.get(f"/endpoints/{opened['id']}")["peers"]
            assert [p["address"] for p in peers] == [f"127.0.0.1:{carrier.client.port}"]
            same = [d for d in api.drones() if d["link"]["systemId"] == drone["link"]["systemId"]]
            assert [d["id"] for d in same] == [drone["id"]]


def test_lets_nobody_in_by_dtls_with_a_wrong_or_revoked_key(api: Api) -> None:
    key = _key(api, "revoked copter")
    with endpoint(api, "dtlsserver://127.0.0.1:0") as opened:
        server = ("127.0.0.1", _port(opened))
        secret = bytes.fromhex(key["secret"])
        DtlsClient(server, key["identity"], secret).close()
        with pytest.raises(HandshakeError):
            DtlsClient(server, key["identity"], bytes(32), timeout=2)
        with pytest.raises(HandshakeError):
            DtlsClient(server, "nobody", secret, timeout=2)

        assert api.call("DELETE", f"/dtls-keys/{key['identity']}").status_code == 204
        with pytest.raises(HandshakeError):
            DtlsClient(server, key["identity"], secret, timeout=2)


def _key(api: Api, label: str) -> Json:
    answer = api.call("POST", "/dtls-keys", {"label": label})
    assert answer.status_code == 201, answer.text
    key: Json = answer.json()
    return key


def test_an_endpoint_that_cannot_open_is_listed_and_tried_again(api: Api) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        answer = api.call("POST", "/endpoints", {"url": f"tcpserver://127.0.0.1:{port}"})
        assert answer.status_code == 201, answer.text
        path = f"/endpoints/{answer.json()['id']}"
        assert answer.json()["state"] == "failed"
        assert "taken by another program" in answer.json()["reason"]
    wait_for("it is open once the port is free", lambda: _open(api.get(path)), 30)
    assert api.call("DELETE", path).status_code == 204


def test_added_endpoints_and_keys_outlive_the_server(tmp_path: Path) -> None:
    server = Server(tmp_path / "data")
    server.start()
    try:
        api = Api(server.address, server.local_key())
        key = _key(api, "lasting copter")
        url = f"dtlsserver://127.0.0.1:{free_port(socket.SOCK_DGRAM)}"
        added = api.call("POST", "/endpoints", {"url": url})
        assert added.status_code == 201, added.text
        server.stop()
        server.start()

        api = Api(server.address, server.local_key())
        listed = api.get(f"/endpoints/{added.json()['id']}")
        assert (listed["url"], listed["state"], listed["origin"]) == (url, "open", "added")
        DtlsClient(("127.0.0.1", _port(listed)), key["identity"], bytes.fromhex(key["secret"])).close()
    finally:
        server.stop()


def test_shows_the_counters_to_whoever_has_a_key(server: Server, api: Api, copter: Json) -> None:
    text = _metrics(server, api.new_key("monitoring", "viewer"))

    endpoints = {e["url"]: e for e in api.get("/endpoints")["endpoints"]}
    udp = endpoints[f"udpserver://127.0.0.1:{server.udp_port}"]
    assert udp["origin"] == "configured"
    assert udp["counts"]["kernelDrops"] == 0
    assert f'dronemap_endpoint_frames_in_total{{endpoint="{udp["id"]}"' in text
    mine = [v for v in api.get("/traffic")["vehicles"] if v["drone"] == copter["id"]]
    assert len(mine) == 1
    assert mine[0]["received"] > 10
    assert mine[0]["sent"] > 1
    assert f'dronemap_vehicle_received_total{{drone="{copter["id"]}"' in text
    assert requests.get(server.address + "/metrics", timeout=5).status_code == 401


def _metrics(server: Server, key: str) -> str:
    headers = {"Authorization": f"Bearer {key}"}
    answer = requests.get(server.address + "/metrics", headers=headers, timeout=5)
    assert answer.ok, answer.text
    return answer.text
