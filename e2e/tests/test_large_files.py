"""Files that are larger than the heap's free room pass a server, or are refused, piece by piece."""

import hashlib
import http.client
import select
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
import requests
import zeep.exceptions

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for

SYSTEM_ID = 33
# What a server takes anyhow leaves no room in it for such a file.
HEAP = "128m"
MEGABYTE = 1 << 20
FILE_BYTES = 100 * MEGABYTE
PIECE_BYTES = 64 * 1024


@dataclass(frozen=True)
class RecordedDrone:
    """A server with a small heap, and a recording of 100 MB that it has."""

    server: Server
    api: Api
    id: str
    file: Path

    def is_well(self) -> bool:
        health = requests.get(self.server.address + "/api/v1/health", timeout=10)
        return health.ok and "OutOfMemory" not in self.server.log()


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RecordedDrone]:
    folder = tmp_path_factory.mktemp("large")
    # It waits so long for the rest of what it has refused.
    server = Server(folder / "data", heap=HEAP, DRONEMAP_SLOW_CLIENT_SECONDS="2")
    server.start()
    link = f"udp://127.0.0.1:{server.udp_port}"
    simulator = Simulator(folder / "sim.log", link, "--sysid", str(SYSTEM_ID), *QUICK_FLIGHT)
    api = Api(server.address, server.local_key())
    drone = wait_for("the copter is ready", lambda: api.ready(SYSTEM_ID), 90)["id"]
    api.do(drone, type="arm")
    api.do(drone, type="disarm")
    recording = wait_for("it was recorded", lambda: _finished(api, drone), 60)["id"]
    simulator.stop()
    file = next((server.data / "recordings").rglob(f"*{recording}*.tlog"))
    flight = file.read_bytes()
    with file.open("ab") as longer:
        while longer.tell() < FILE_BYTES:
            longer.write(flight)
    yield RecordedDrone(server, api, recording, file)
    server.stop()


def _finished(api: Api, drone: str) -> Json | None:
    listed = api.get(f"/recordings?drone={drone}")["recordings"]
    return listed[0] if listed and listed[0]["state"] != "running" else None


def _sum(pieces: Iterator[bytes]) -> str:
    digest = hashlib.sha256()
    for piece in pieces:
        digest.update(piece)
    return digest.hexdigest()


def _pieces(file: Path) -> Iterator[bytes]:
    with file.open("rb") as opened:
        while piece := opened.read(PIECE_BYTES):
            yield piece


def test_rest_download_of_large_recording(recorded: RecordedDrone) -> None:
    """End to end because the heap is that of a process of its own, which one download would fill."""
    address = f"{recorded.api.base}/recordings/{recorded.id}/file"
    key = {"Authorization": f"Bearer {recorded.api.key}"}
    expected = _sum(_pieces(recorded.file))
    with (
        requests.get(address, headers=key, stream=True, timeout=60) as one,
        requests.get(address, headers=key, stream=True, timeout=60) as other,
    ):
        assert int(one.headers["Content-Length"]) == recorded.file.stat().st_size > FILE_BYTES - 1
        assert _sum(one.iter_content(PIECE_BYTES)) == expected
        assert _sum(other.iter_content(PIECE_BYTES)) == expected
    assert recorded.is_well()


def test_soap_refers_to_rest_for_large_recording(recorded: RecordedDrone) -> None:
    """End to end because the heap is that of a process of its own, which one such message would fill."""
    service = soap(recorded.server, recorded.server.local_key(), "RecordService")
    with pytest.raises(zeep.exceptions.Fault) as raised:
        service.getRecordingFile(recordingId=recorded.id)
    assert raised.value.message == (
        "This answer is longer than a SOAP message may be, 4194304 bytes; get it by"
        " GET /api/v1/recordings/{id}/file with the same key, or ask for less."
    )
    assert recorded.is_well()


def test_replay_of_large_recording(recorded: RecordedDrone) -> None:
    """End to end because the heap is that of a process of its own, which the file would fill."""
    answer = requests.post(
        f"{recorded.api.base}/replays",
        headers={"Authorization": f"Bearer {recorded.api.key}", "Content-Type": "application/octet-stream"},
        data=_pieces(recorded.file),
        timeout=60,
    )
    assert answer.status_code == 202, answer.text
    assert recorded.api.call("DELETE", f"/replays/{answer.json()['id']}").status_code == 204
    assert recorded.is_well()


@pytest.mark.parametrize(
    ("address", "kind", "most"),
    [
        ("/services/RecordService", "text/xml", "1 MB"),
        ("/api/v1/zones/import", "application/json", "4 MB"),
    ],
)
def test_too_long_upload_is_refused_early(
    recorded: RecordedDrone, address: str, kind: str, most: str
) -> None:
    """End to end because the heap is that of a process of its own, and its socket says when it has enough."""
    status, text, sent = _upload(recorded, address, kind)
    assert status == 413
    assert f"may have at most {most}" in text
    assert sent < FILE_BYTES
    assert recorded.is_well()


def _upload(recorded: RecordedDrone, address: str, kind: str) -> tuple[int, str, int]:
    """Sends until there is an answer: status, body and how many bytes were sent."""
    connection = http.client.HTTPConnection("127.0.0.1", recorded.server.http_port, timeout=60)
    connection.putrequest("POST", address)
    connection.putheader("Authorization", f"Bearer {recorded.api.key}")
    connection.putheader("Content-Type", kind)
    connection.putheader("Content-Length", str(FILE_BYTES))
    connection.endheaders()
    sent = 0
    while sent < FILE_BYTES and not select.select([connection.sock], [], [], 0)[0]:
        connection.send(b" " * PIECE_BYTES)
        sent += PIECE_BYTES
    answer = connection.getresponse()
    text = answer.read().decode()
    connection.close()
    return answer.status, text, sent
