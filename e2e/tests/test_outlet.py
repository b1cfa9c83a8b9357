"""Ground stations of other makers attach by all that carries frames; with pymavlink's own signing."""

import hashlib
from collections.abc import Iterator

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.dtls import DtlsClient, HandshakeError
from dronemap_e2e.frame_links import WebSocketLink
from dronemap_e2e.ground_station import Attach, User, new_user
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import now_ticks
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for


@pytest.fixture
def viewer(server: Server, api: Api) -> User:
    return new_user(server, api, "viewer")


@pytest.fixture(scope="module")
def same_id_copters(
    server: Server, api: Api, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[list[Json]]:
    """Two copters that both call themselves system 1."""
    folder = tmp_path_factory.mktemp("twins")
    before = {d["id"] for d in api.drones()}
    started = [
        Simulator(
            folder / f"{number}.log",
            f"udp://127.0.0.1:{server.udp_port}",
            *("--count", "1", "--sysid", "1", "--hardware", str(4001 + number)),
        )
        for number in range(2)
    ]

    def listed() -> list[Json] | None:
        new = [d for d in api.drones() if d["id"] not in before and d["link"]["systemId"] == 1]
        return new if len([d for d in new if d["link"]["state"] == "live"]) == 2 else None

    yield wait_for("both are listed", listed, 90)
    for simulator in started:
        simulator.stop()


def wait_for_both_heartbeats(
    same_id_copters: list[Json], user: User, client: DtlsClient | WebSocketLink
) -> None:
    """Attaches by what carries frames, and waits for the vehicles' heartbeats."""
    writer = mavlink.MAVLink(None, srcSystem=250, srcComponent=190)
    writer.signing.secret_key = hashlib.sha256(user.passphrase.encode()).digest()
    writer.signing.sign_outgoing = True
    writer.signing.timestamp = now_ticks()
    client.send(bytes(writer.heartbeat_encode(6, 8, 0, 0, 4).pack(writer)))
    reader = mavlink.MAVLink(None)
    system_ids: set[int] = set()

    def both() -> bool:
        frames = reader.parse_buffer(client.receive()) or []
        system_ids.update(m.get_srcSystem() for m in frames if m.get_type() == "HEARTBEAT")
        return len(system_ids - {254, 255}) >= len(same_id_copters)

    wait_for("both are heard", both, 20, 0.001)
    client.close()


def test_clients_attach_by_udp_tcp_websocket_and_dtls_with_signed_frames(
    same_id_copters: list[Json], server: Server, attach: Attach, viewer: User
) -> None:
    """End to end because real sockets carry it, OpenSSL shakes hands, and pymavlink judges the signatures."""
    for tcp in (False, True):
        ground = attach(viewer, tcp=tcp)
        both = ground.wait_vehicles(len(same_id_copters))
        assert {m.get_srcSystem() for m in ground.all_messages} <= both
        assert all(m.get_signed() for m in ground.all_messages)
        assert ground.link.mav.signing.badsig_count == 0
        assert [ground.gaps(number) for number in both] == [0] * len(both)
        ground.close()
    wait_for_both_heartbeats(same_id_copters, viewer, WebSocketLink(server.outlet_web_socket_port))

    # By DTLS with the user's own key alone.
    key = hashlib.sha256(viewer.passphrase.encode()).digest()
    outlet = ("127.0.0.1", server.outlet_dtls_port)
    with pytest.raises(HandshakeError):
        DtlsClient(outlet, viewer.name, key, timeout=2)
    with pytest.raises(HandshakeError):
        DtlsClient(outlet, "nobody", hashlib.sha256(key).digest(), timeout=2)
    wait_for_both_heartbeats(
        same_id_copters, viewer, DtlsClient(outlet, viewer.name, hashlib.sha256(key).digest())
    )
