"""Secrets that were put in are not found in what is kept: backups, recordings, logs of the server."""

import base64
import io
import secrets
import zipfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import SigningPeer
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    """One of its own, which records from the first message on, so that keys on their way are met."""
    started = Server(tmp_path / "data", DRONEMAP_RECORD="always")
    started.start()
    yield started
    started.stop()


@pytest.fixture
def api(server: Server) -> Api:
    return Api(server.address, server.local_key())


@pytest.fixture
def peer(server: Server) -> Iterator[SigningPeer]:
    started = SigningPeer(server.udp_port, next(SYSTEM_IDS))
    yield started
    started.close()


def shown_once(api: Api, path: str, body: Json, member: str) -> str:
    """A value that only this one answer shows."""
    answer = api.call("POST", path, body)
    assert answer.status_code in (200, 201), answer.text
    shown: str = answer.json()[member]
    return shown


def create_secrets(server: Server, api: Api, drone: str) -> dict[str, str]:
    """A secret of every kind, each used once."""
    password, own = (f"canary-{secrets.token_hex(8)}" for _ in range(2))
    name = f"canary-{secrets.token_hex(4)}"
    body = {"name": name, "password": password, "role": "operator"}
    assert api.call("POST", "/users", body).status_code == 201
    session = Api(server.address)
    signed_in = session.call("POST", "/session", {"name": name, "password": password})
    assert signed_in.ok and signed_in.cookies, signed_in.text
    change = {"current": password, "next": own}
    assert session.call("POST", "/session/password", change).status_code == 204
    return {
        "the key of its own machine": server.local_key(),
        "the first password": server.first_password(),
        "a password that was given": password,
        "a password": own,
        "a session": str(next(iter(signed_in.cookies)).value),
        "an access key": session.new_key("canary", "operator"),
        "the key of a DTLS link": shown_once(api, "/dtls-keys", {"label": name}, "secret"),
        "an invitation": shown_once(api, "/invitations", {"label": name, "role": "viewer"}, "code"),
        "a ticket of the stream": shown_once(session, "/stream-tickets", {}, "ticket"),
        "the key of a vehicle": shown_once(api, f"/drones/{drone}/link-key", {}, "key"),
    }


def encodings(secret: str) -> set[bytes]:
    """A secret as text and as bytes, in the encodings that files may have."""
    plain = {secret.encode()}
    try:
        plain.add(bytes.fromhex(secret))
    except ValueError:
        plain.add(base64.urlsafe_b64decode(secret + "=" * (-len(secret) % 4)) if len(secret) > 30 else b"")
    plain.discard(b"")
    encoded = {each.hex().encode() for each in plain} | {
        base64.b64encode(each).rstrip(b"=") for each in plain
    }
    return plain | encoded | {each.upper() for each in encoded if each.islower()}


def test_no_backup_recording_or_log_contains_a_secret(server: Server, api: Api, peer: SigningPeer) -> None:
    """End to end because backups are those of a real PostgreSQL, and logs those of a whole process."""
    drone = wait_for("the peer is listed", lambda: _listed(api, peer), 30)
    canaries = create_secrets(server, api, drone)
    assert api.call("POST", f"/drones/{drone}/link-key/install").status_code == 200
    assert peer.keys == [bytes.fromhex(canaries["the key of a vehicle"])]
    recording = wait_for("it is recorded", partial(_recording, api, drone), 30)

    backup = api.call("POST", "/backup").content
    flight = api.call("GET", f"/recordings/{recording}/file").content
    sent = api.call("GET", f"/recordings/{recording}/sent").content
    with zipfile.ZipFile(io.BytesIO(backup)) as zipped:
        kept = {f"{name} of the backup": zipped.read(name) for name in zipped.namelist()}
    kept |= {"the recording": flight, "what was sent": sent}
    kept |= {path.name: path.read_bytes() for path in server.data.rglob("*.log")}
    assert len(kept) > 15 and len(flight) > 1_000, {what: len(data) for what, data in kept.items()}
    assert any(b"canary-" in data for what, data in kept.items() if "backup" in what), "the users are in it"
    found = [
        f"{what} in {where}"
        for what, secret in canaries.items()
        for form in encodings(secret)
        for where, data in kept.items()
        if form in data
    ]
    assert not found, found


def _listed(api: Api, peer: SigningPeer) -> str | None:
    return next((str(d["id"]) for d in api.drones() if d["link"]["port"] == peer.port), None)


def _recording(api: Api, drone: str) -> str | None:
    found = api.get(f"/recordings?drone={drone}")["recordings"]
    return str(found[0]["id"]) if found and found[0]["frames"] > 50 else None
