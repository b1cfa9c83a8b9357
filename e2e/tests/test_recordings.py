"""Flights recorded: the file is what went over the wire, byte for byte, and other programs read it."""

import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import requests
from pymavlink import mavutil

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import wait_for

CLOUD = 255
TIME_BYTES = 8


def records(tlog: bytes) -> list[tuple[int, bytes]]:
    """Time in microseconds and frame of each record, read by the letter of the format."""
    found = []
    at = 0
    while at < len(tlog):
        micros = int.from_bytes(tlog[at : at + TIME_BYTES], "big")
        at += TIME_BYTES
        assert tlog[at] in (0xFD, 0xFE), f"no frame begins at byte {at}"
        header = 10 if tlog[at] == 0xFD else 6
        length = header + tlog[at + 1] + 2
        assert tlog[at] == 0xFE or tlog[at + 2] & 1 == 0, "a signature was kept"
        found.append((micros, tlog[at : at + length]))
        at += length
    return found


def sender(frame: bytes) -> int:
    return frame[5] if frame[0] == 0xFD else frame[3]


def is_part(part: list[bytes], whole: list[bytes]) -> bool:
    """Without a gap."""
    return any(
        whole[start : start + len(part)] == part for start, frame in enumerate(whole) if frame == part[0]
    )


def recording_of(api: Api, drone: str, state: str) -> Json | None:
    listed = api.get(f"/recordings?drone={drone}")["recordings"]
    return listed[0] if listed and listed[0]["state"] == state else None


def download(api: Api, recording: str) -> bytes:
    answer = api.call("GET", f"/recordings/{recording}/file")
    assert answer.ok, answer.text
    return answer.content


def told(api: Api, drone: str, recording: str, kept: list[tuple[int, bytes]]) -> set[str]:
    """Types of the commands for which something was sent, as noted beside the recording."""
    answer = api.call("GET", f"/recordings/{recording}/sent")
    assert answer.ok, answer.text
    header, *lines = answer.text.splitlines()
    assert header.split("\t") == ["offset", "command", "epoch", "by"]
    noted = [line.split("\t") for line in lines]
    offsets = [0]
    for _, frame in kept:
        offsets.append(offsets[-1] + TIME_BYTES + len(frame))
    down = [at for at, (_, frame) in zip(offsets, kept, strict=False) if sender(frame) == CLOUD]
    assert [int(offset) for offset, *_ in noted] == down
    commands = {c["id"]: c for c in api.get(f"/drones/{drone}/commands")["commands"]}
    for _, command, epoch, by in noted:
        if command != "-":
            assert (epoch, by) == (str(commands[command]["epoch"]), commands[command]["by"])
    return {commands[command]["type"] for _, command, *_ in noted if command != "-"}


def fly(api: Api, drone: str) -> None:
    api.do(drone, type="arm")
    api.do(drone, type="takeOff", altitude=8)
    api.do(drone, type="land")
    wait_for("it landed and disarmed", lambda: api.drone(drone)["armed"] is False, 120)


def test_a_flight_is_recorded_byte_for_byte_in_both_directions(
    api: Api, tap: Tap, copter: Json, tmp_path: Path
) -> None:
    drone = copter["id"]
    began = time.monotonic()
    wait_for("it was heard for some seconds before the flight", lambda: tap.heard(up=True, since=began + 4))
    fly(api, drone)
    done = wait_for("the recording is complete", lambda: recording_of(api, drone, "complete"), 60)

    tlog = download(api, done["id"])
    kept = records(tlog)
    assert (len(kept), len(tlog)) == (done["frames"], done["bytes"])
    assert [micros for micros, _ in kept] == sorted(micros for micros, _ in kept)
    up = [frame for _, frame in kept if sender(frame) != CLOUD]
    down = [frame for _, frame in kept if sender(frame) == CLOUD]
    on_wire = {
        direction: [bytes(h.message.get_msgbuf()) for h in tap.heard(up=direction)]
        for direction in (True, False)
    }
    assert len(up) > 100 and is_part(up, on_wire[True]), "what the vehicle said"
    assert len(down) > 10 and is_part(down, on_wire[False]), "what the vehicle was told"
    assert told(api, drone, done["id"], kept) == {"arm", "takeOff", "land"}
    first = kept[0][0] / 1e6
    armed = next(m for m in read(tlog, tmp_path) if m.get_type() == "HEARTBEAT" and m.base_mode & 0x80)
    assert armed._timestamp - first > 3, "the seconds before arming are missing"


def read(tlog: bytes, folder: Path) -> list[Any]:
    """As pymavlink reads it."""
    path = folder / "flight.tlog"
    path.write_bytes(tlog)
    log = mavutil.mavlink_connection(str(path))
    messages = []
    while (message := log.recv_match()) is not None:
        messages.append(message)
    return messages


def test_other_programs_read_it(api: Api, copter: Json, tmp_path: Path) -> None:
    drone = copter["id"]
    api.do(drone, type="arm")
    going_on = wait_for("it is recorded", lambda: recording_of(api, drone, "running"), 30)
    tlog = download(api, going_on["id"])
    messages = read(tlog, tmp_path)
    assert len(messages) == len(records(tlog))
    assert not [m for m in messages if m.get_type() == "BAD_DATA"]
    dump = shutil.which("mavlogdump.py", path=str(Path(sys.executable).parent))
    assert dump is not None, "pymavlink's mavlogdump.py is not there"
    text = subprocess.run(
        [sys.executable, dump, "--types", "COMMAND_LONG,COMMAND_ACK", str(tmp_path / "flight.tlog")],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert "COMMAND_LONG {" in text and "command : 400" in text, text
    assert "COMMAND_ACK {" in text, text
    api.do(drone, type="disarm")


def test_a_recording_is_played_and_deleted(server: Server, api: Api, copter: Json) -> None:
    drone = copter["id"]
    api.do(drone, type="arm")
    api.do(drone, type="disarm")
    done = wait_for("the recording is complete", lambda: recording_of(api, drone, "complete"), 60)
    viewer = Api(server.address, api.new_key("looks", "viewer"))
    assert viewer.call("GET", f"/recordings/{done['id']}/file").ok
    assert viewer.call("DELETE", f"/recordings/{done['id']}?confirm=true").status_code == 403

    replay = api.call("POST", f"/recordings/{done['id']}/replays?speed=10").json()
    shown = wait_for("it is played", lambda: api.get(f"/replays/{replay['id']}")["drones"], 30)
    assert api.drone(shown[0])["replay"] is True
    api.call("DELETE", f"/replays/{replay['id']}")

    unsure = api.call("DELETE", f"/recordings/{done['id']}")
    assert (unsure.status_code, unsure.json()["field"]) == (422, "confirm")
    assert api.call("DELETE", f"/recordings/{done['id']}?confirm=true").status_code == 204
    assert api.call("GET", f"/recordings/{done['id']}").status_code == 404


def test_a_crash_leaves_a_recording_that_can_be_read(tmp_path: Path) -> None:
    server = Server(tmp_path / "data")
    server.start()
    simulator = Simulator(tmp_path / "sim.log", f"udp://127.0.0.1:{server.udp_port}", "--count", "1")
    try:
        api = Api(server.address, server.local_key())
        drone = wait_for("the copter is ready", lambda: api.ready(1), 90)["id"]
        api.do(drone, type="arm")
        before = wait_for("some of it is written", lambda: written(api, drone, 200), 30)
        server.kill()
        server.start()
        again = Api(server.address, server.local_key())
        mended = again.get(f"/recordings/{before['id']}")
        assert mended["state"] == "incomplete"
        assert "server stopped" in mended["notice"]
        assert mended["frames"] >= before["frames"]
        tlog = download(again, mended["id"])
        assert len(records(tlog)) == mended["frames"]
    except requests.ConnectionError as e:
        raise AssertionError(server.data.joinpath("server.log").read_text()[-2000:]) from e
    finally:
        simulator.stop()
        server.stop()


def written(api: Api, drone: str, frames: int) -> Json | None:
    running = recording_of(api, drone, "running")
    return running if running and running["frames"] >= frames else None
