"""Ground stations of other makers attach: who gets in, and what they see; with pymavlink's own signing."""

import hashlib
import secrets
import socket
import time
from collections.abc import Iterator

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.carriers import WebSocketCaller
from dronemap_e2e.dtls import DtlsClient, HandshakeError
from dronemap_e2e.ground import Attach, Ground, User, new_user
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import MINUTE, now_ticks, resigned
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import throughout, wait_for


@pytest.fixture
def viewer(server: Server, api: Api) -> User:
    return new_user(server, api, "viewer")


@pytest.fixture(scope="module")
def twins(server: Server, api: Api, tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[Json]]:
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


def refused(api: Api, why: str) -> int:
    return int(api.get("/outlet/clients")["refused"][why])


def own(api: Api, user: User) -> list[Json]:
    clients: list[Json] = api.get("/outlet/clients")["clients"]
    return [c for c in clients if c["user"] == user.name]


@pytest.mark.parametrize("tcp", [False, True], ids=["udp", "tcp"])
def test_vehicles_with_one_system_id_are_told_apart_and_every_frame_is_signed(
    twins: list[Json], attach: Attach, viewer: User, tcp: bool
) -> None:
    ground = attach(viewer, tcp=tcp)
    both = ground.wait_vehicles(len(twins))
    wait_for(
        "both tell where they are",
        lambda: all(len(ground.heard("GLOBAL_POSITION_INT", number)) > 5 for number in both),
    )
    assert {m.get_srcSystem() for m in ground.messages} <= both
    assert all(m.get_signed() for m in ground.messages)
    assert ground.link.mav.signing.badsig_count == 0
    assert [ground.gaps(number) for number in both] == [0] * len(both)


def test_a_user_knows_each_drone_by_the_same_number_ever_after(
    twins: list[Json], attach: Attach, viewer: User, api: Api
) -> None:
    first = attach(viewer, tcp=False)
    before = first.wait_vehicles(len(twins))
    places = {number: _place(first, number) for number in before}
    first.close()
    again = attach(viewer, tcp=True, system_id=254)
    assert again.wait_vehicles(len(twins)) == before
    assert {number: _place(again, number) for number in before} == places
    assert len({client["user"] for client in own(api, viewer)}) <= 1


def _place(ground: Ground, number: int) -> tuple[int, int]:
    wait_for("it tells where its home is", lambda: ground.heard("GLOBAL_POSITION_INT", number))
    last = ground.heard("GLOBAL_POSITION_INT", number)[-1]
    return round(last.lat / 1e3), round(last.lon / 1e3)


def test_a_client_never_has_the_number_of_a_vehicle(twins: list[Json], attach: Attach, viewer: User) -> None:
    taken = attach(viewer, tcp=False).wait_vehicles(len(twins))
    for number in sorted(taken)[:1]:
        twin = attach(viewer, tcp=True, system_id=number)
        seen = twin.wait_vehicles(len(twins))
        assert number not in seen


def test_strangers_and_wrong_passphrases_see_nothing_and_are_counted(
    twins: list[Json], attach: Attach, viewer: User, api: Api
) -> None:
    unsigned, wrong = refused(api, "unsigned"), refused(api, "badSignature")
    strangers = [
        attach(None, tcp=False),
        attach(None, tcp=True),
        attach(viewer._replace(passphrase=secrets.token_hex(12)), tcp=False),
        attach(viewer._replace(passphrase=secrets.token_hex(12)), tcp=True),
    ]
    wait_for("unsigned frames are counted", lambda: refused(api, "unsigned") >= unsigned + 6)
    wait_for("wrong signatures are counted", lambda: refused(api, "badSignature") >= wrong + 6)
    assert [len(ground.messages) for ground in strangers] == [0] * len(strangers)
    assert own(api, viewer) == []


def test_replayed_and_old_frames_see_nothing(
    twins: list[Json], server: Server, attach: Attach, viewer: User, api: Api
) -> None:
    key = hashlib.sha256(viewer.passphrase.encode()).digest()
    writer = mavlink.MAVLink(None, srcSystem=250, srcComponent=190)
    writer.signing.secret_key, writer.signing.sign_outgoing = key, True
    writer.signing.timestamp = now_ticks()
    frame = bytes(writer.heartbeat_encode(6, 8, 0, 0, 4).pack(writer))
    old, replayed = refused(api, "tooOld"), refused(api, "replayed")

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.connect(("127.0.0.1", server.outlet_udp_port))
        sock.settimeout(0.2)
        sock.send(resigned(frame, key, now_ticks() - 2 * MINUTE, 7))
        wait_for("an old one is counted", lambda: refused(api, "tooOld") == old + 1)
        with pytest.raises(TimeoutError):
            sock.recv(300)

        sock.settimeout(10)
        sock.send(frame)
        assert sock.recv(300)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as thief:
        thief.connect(("127.0.0.1", server.outlet_udp_port))
        thief.settimeout(0.5)
        for _ in range(3):
            thief.send(frame)
        wait_for("the replay is counted", lambda: refused(api, "replayed") == replayed + 3)
        with pytest.raises(TimeoutError):
            thief.recv(300)


def test_a_grant_taken_back_silences_an_attached_client_within_a_second(
    twins: list[Json], attach: Attach, viewer: User, api: Api
) -> None:
    assert api.call("PUT", f"/users/{viewer.name}/only-granted", {"onlyGranted": True}).status_code == 204
    ground = attach(viewer, tcp=False)
    wait_for("it is attached", lambda: own(api, viewer))
    wait_for("the cloud says that it is there", lambda: ground.heard("HEARTBEAT"))
    assert ground.vehicles() == set()

    body = {"user": viewer.name, "drones": [twins[0]["id"]], "operations": ["view"]}
    answer = api.call("POST", "/grants", body)
    assert answer.status_code == 201, answer.text
    seen = ground.wait_vehicles(1)
    assert len(seen) == 1

    assert api.call("DELETE", f"/grants/{answer.json()['id']}").status_code == 204
    taken = time.monotonic()
    wait_for("a second has passed", lambda: time.monotonic() > taken + 1.0)
    throughout(
        "nothing more of the drone comes",
        lambda: max(ground.arrived[number] for number in seen) < taken + 1.0,
        2,
    )


def test_a_disabled_user_is_silenced_within_a_second_and_stays_outside(
    twins: list[Json], attach: Attach, viewer: User, api: Api
) -> None:
    ground = attach(viewer, tcp=False)
    seen = ground.wait_vehicles(len(twins))
    assert api.call("PATCH", f"/users/{viewer.name}", {"state": "disabled"}).ok
    taken = time.monotonic()
    wait_for("the client is gone", lambda: not own(api, viewer))
    throughout("nothing more comes", lambda: max(ground.arrived[number] for number in seen) < taken + 1.0, 2)


def test_a_client_follows_to_another_address_and_a_disconnected_one_stays_outside(
    twins: list[Json], attach: Attach, viewer: User, api: Api
) -> None:
    first = attach(viewer, tcp=False)
    first.wait_vehicles(len(twins))
    first.silent = True
    moved = attach(viewer, tcp=False)
    moved.wait_vehicles(len(twins))
    port = moved.link.port.getsockname()[1]
    client = next(c for c in own(api, viewer) if c["address"].endswith(f":{port}"))

    assert api.call("DELETE", f"/outlet/clients/{client['id']}").status_code == 204
    wait_for("it is gone", lambda: client["id"] not in [c["id"] for c in own(api, viewer)])
    count = len(moved.messages)
    throughout("it gets nothing more", lambda: len(moved.messages) <= count + 20, 2)
    assert api.call("DELETE", "/outlet/clients/nobody").status_code == 404


def test_another_passphrase_ends_the_clients_of_the_one_before(
    twins: list[Json], attach: Attach, viewer: User, api: Api
) -> None:
    attach(viewer, tcp=False).wait_vehicles(len(twins))
    chosen = f"correct horse {secrets.token_hex(4)}"
    answer = viewer.api.call("PUT", "/outlet/passphrase", {"passphrase": chosen})
    assert answer.json() == {"passphrase": chosen}
    wait_for("the client of the old one is gone", lambda: not own(api, viewer))
    attach(viewer._replace(passphrase=chosen), tcp=False).wait_vehicles(len(twins))

    assert viewer.api.call("DELETE", "/outlet/passphrase").status_code == 204
    wait_for("no client is left", lambda: not own(api, viewer))
    assert viewer.api.get("/outlet")["passphraseSet"] is False


def hear_both(twins: list[Json], user: User, client: DtlsClient | WebSocketCaller) -> None:
    """Attaches by what carries frames, and waits for the vehicles' heartbeats."""
    writer = mavlink.MAVLink(None, srcSystem=250, srcComponent=190)
    writer.signing.secret_key = hashlib.sha256(user.passphrase.encode()).digest()
    writer.signing.sign_outgoing = True
    writer.signing.timestamp = now_ticks()
    client.send(bytes(writer.heartbeat_encode(6, 8, 0, 0, 4).pack(writer)))
    reader = mavlink.MAVLink(None)
    heard: set[int] = set()

    def both() -> bool:
        frames = reader.parse_buffer(client.receive()) or []
        heard.update(m.get_srcSystem() for m in frames if m.get_type() == "HEARTBEAT")
        return len(heard - {254, 255}) >= len(twins)

    wait_for("both are heard", both, 20, 0.001)
    client.close()


def test_a_client_may_attach_by_dtls_with_the_users_own_key_only(
    twins: list[Json], server: Server, viewer: User
) -> None:
    key = hashlib.sha256(viewer.passphrase.encode()).digest()
    outlet = ("127.0.0.1", server.outlet_dtls_port)
    with pytest.raises(HandshakeError):
        DtlsClient(outlet, viewer.name, key, timeout=2)
    with pytest.raises(HandshakeError):
        DtlsClient(outlet, "nobody", hashlib.sha256(key).digest(), timeout=2)
    hear_both(twins, viewer, DtlsClient(outlet, viewer.name, hashlib.sha256(key).digest()))


def test_a_client_may_attach_by_web_socket(twins: list[Json], server: Server, viewer: User) -> None:
    hear_both(twins, viewer, WebSocketCaller(server.outlet_web_socket_port))
