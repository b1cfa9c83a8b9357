"""What is written into files and read from them."""

import stat
from pathlib import Path

import contract_samples as samples
import pytest
from fake_server import FakeServer, command, drone, problem, run

from dronectl.failure import BadFile
from dronectl.track import read_track


@pytest.fixture
def server(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> FakeServer:
    monkeypatch.chdir(tmp_path)
    return FakeServer(drones=[drone(name="Heron 1/a")])


def test_log_is_fetched_from_the_vehicle_where_the_server_has_none(server: FakeServer, tmp_path: Path) -> None:
    server.answers["GET /drones/d1/logs"] = {"logs": [{"number": 2, "sizeBytes": 3, "here": False}]}
    server.answers["POST /drones/d1/logs/2/download"] = command("downloadLog")
    server.answers["GET /drones/d1/logs/2/file"] = b"\0log"
    result = run(server, "logs", "download", "2")
    assert result.exit_code == 0, result.stderr
    # Nobody's name for a drone leads out of the folder.
    assert (tmp_path / "Heron-1-a-2.bin").read_bytes() == b"\0log"
    assert [file.name for file in tmp_path.iterdir()] == ["Heron-1-a-2.bin"]


def test_log_that_the_server_has_is_not_fetched_again(server: FakeServer, tmp_path: Path) -> None:
    server.answers["GET /drones/d1/logs"] = samples.LOGS
    server.answers["GET /drones/d1/logs/1/file"] = b"log"
    assert run(server, "logs", "download", "1", "mine.bin").exit_code == 0
    assert (tmp_path / "mine.bin").read_bytes() == b"log"


def test_log_that_the_vehicle_does_not_give(server: FakeServer, tmp_path: Path) -> None:
    server.answers["GET /drones/d1/logs"] = {"logs": []}
    server.answers["POST /drones/d1/logs/7/download"] = lambda asked: problem(404, "It has no log 7.", "log-unknown")
    result = run(server, "logs", "download", "7")
    assert (result.exit_code, result.stderr) == (1, "dronectl: It has no log 7. [log-unknown]\n")
    assert list(tmp_path.iterdir()) == []


def test_logs_that_were_never_listed_are_read_first(server: FakeServer) -> None:
    answers = [{"logs": None}, samples.LOGS]
    server.answers["GET /drones/d1/logs"] = lambda asked: answers.pop(0)
    server.answers["POST /drones/d1/logs/refresh"] = command("readLogs")
    assert "2026" in run(server, "logs", "list").stdout


def test_parameters_that_were_never_read_are_read_first(server: FakeServer) -> None:
    answers = [{"total": 0, "parameters": [], "readAt": None}, samples.PARAMETERS]
    server.answers["GET /drones/d1/parameters"] = lambda asked: answers.pop(0)
    server.answers["POST /drones/d1/parameters/refresh"] = command("readParameters")
    assert run(server, "params", "get", "RTL_ALT").stdout == "1500\n"


def test_parameter_that_there_is_not(server: FakeServer) -> None:
    server.answers["GET /drones/d1/parameters"] = samples.PARAMETERS
    result = run(server, "params", "get", "RTL")
    assert result.exit_code == 1
    assert "it has RTL_ALT" in result.stderr


def test_recording_is_written_whole_or_not_at_all(server: FakeServer, tmp_path: Path) -> None:
    (tmp_path / "r1.tlog").write_bytes(b"before")
    server.answers["GET /recordings/r1/file"] = lambda asked: problem(404, "There is none.", "recording-unknown")
    assert run(server, "record", "download", "r1").exit_code == 1
    assert (tmp_path / "r1.tlog").read_bytes() == b"before"
    server.answers["GET /recordings/r1/file"] = b"after"
    assert run(server, "record", "download", "r1").exit_code == 0
    assert (tmp_path / "r1.tlog").read_bytes() == b"after"


def test_file_that_cannot_be_written(server: FakeServer) -> None:
    server.answers["GET /recordings/r1/file"] = b"after"
    result = run(server, "record", "download", "r1", "no/such/folder.tlog")
    assert result.exit_code == 1
    assert "No such file or directory" in result.stderr


def test_made_key_goes_into_a_file_that_nobody_else_reads(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "key"
    file.write_text("an older and much longer key than the new one is")
    file.chmod(0o644)
    server.answers["POST /access-keys"] = samples.KEY | {"key": "secret"}
    result = run(server, "keys", "make", "CI", "--output", str(file))
    assert result.exit_code == 0
    assert "secret" not in result.output
    assert file.read_text() == "secret\n"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600


def test_key_that_is_not_made_leaves_the_file_alone(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "key"
    file.write_text("old")
    server.answers["POST /access-keys"] = lambda asked: problem(403, "No.", "role-too-low")
    assert run(server, "keys", "make", "CI", "--output", str(file)).exit_code == 1
    assert file.read_text() == "old"


def test_first_password_comes_from_a_file_or_is_made_up(server: FakeServer, tmp_path: Path) -> None:
    server.answers["POST /users"] = samples.USER
    (tmp_path / "password").write_text("correct horse\n")
    result = run(server, "users", "add", "tom", "viewer", "--password-file", "password")
    assert server.last("POST", "/users").body["password"] == "correct horse"
    assert "correct horse" not in result.output
    made_up = run(server, "users", "add", "tom", "viewer")
    assert server.last("POST", "/users").body["password"] in made_up.stderr
    refusal = problem(422, "The password must have 10 characters.", "text-length")
    server.answers["POST /users"] = lambda asked: refusal
    too_short = run(server, "users", "add", "tom", "viewer", "--password-file", "-", input="short")
    assert too_short.exit_code == 1
    assert "must have 10 characters" in too_short.stderr


GPX = """<?xml version="1.0"?><gpx xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>
<trkpt lat="47.0" lon="8.0"><time>2026-01-01T00:00:00Z</time></trkpt>
<trkpt lat="47.0001" lon="8.0"><time>2026-01-01T00:00:10Z</time></trkpt></trkseg></trk></gpx>"""


@pytest.mark.parametrize(
    "text", [GPX, "latitude,longitude,seconds\n47.0,8.0,5\n47.0001,8.0,15\n", "longitude,latitude\n8,47\n8,47.0001\n"]
)
def test_way_leads_straight_from_point_to_point(tmp_path: Path, text: str) -> None:
    file = tmp_path / "way"
    file.write_text(text)
    track = read_track(file, 11.12 / 10)
    assert track.length == pytest.approx(10, abs=0.01)
    half = track.at(track.length / 2)
    assert half.latitude == pytest.approx(47.00005)
    assert half.longitude == pytest.approx(8.0)
    assert half.speed == pytest.approx(1.112, abs=0.001)
    assert half.course == pytest.approx(0)
    end = track.at(99)
    assert end.latitude == pytest.approx(47.0001)
    assert end.speed == 0
    assert track.at(-1).latitude == pytest.approx(47.0)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("<gpx", "no GPX"),
        ("<gpx/>", "no way"),
        ("a,b\n1,2\n", "must be GPX, or CSV"),
        ("latitude,longitude\n1,2\n", "no way"),
        ("latitude,longitude\n1,x\n", "line 2"),
        ("latitude,longitude\n1,200\n1,2\n", "from -180 to 180"),
        ("latitude,longitude,seconds\n1,2,5\n1,3,4\n", "do not rise"),
    ],
)
def test_way_that_cannot_be_walked(tmp_path: Path, text: str, why: str) -> None:
    file = tmp_path / "way"
    file.write_text(text)
    with pytest.raises(BadFile, match=why):
        read_track(file, 1.4)
