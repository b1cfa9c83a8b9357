"""Flights recorded: other programs read the file."""

import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

from pymavlink import mavutil

from dronemap_e2e.api import Api, Json
from dronemap_e2e.waiting import wait_for

TIME_BYTES = 8


def records(tlog: bytes) -> int:
    """Counts records by the format's definition."""
    count = at = 0
    while at < len(tlog):
        at += TIME_BYTES
        assert tlog[at] in (0xFD, 0xFE), f"no frame begins at byte {at}"
        at += (10 if tlog[at] == 0xFD else 6) + tlog[at + 1] + 2
        count += 1
    return count


def recording_of(api: Api, drone: str, state: str) -> Json | None:
    listed = api.get(f"/recordings?drone={drone}")["recordings"]
    return listed[0] if listed and listed[0]["state"] == state else None


def download(api: Api, recording: str) -> bytes:
    answer = api.call("GET", f"/recordings/{recording}/file")
    assert answer.ok, answer.text
    return answer.content


def read(tlog: bytes, folder: Path) -> list[Any]:
    """Messages of a recording as pymavlink reads them."""
    path = folder / "flight.tlog"
    path.write_bytes(tlog)
    log = mavutil.mavlink_connection(str(path))
    messages = []
    while (message := log.recv_match()) is not None:
        messages.append(message)
    return messages


def test_recording_is_read_by_pymavlink_and_mavlogdump(api: Api, copter: Json, tmp_path: Path) -> None:
    """End to end because pymavlink and mavlogdump.py are those other programs."""
    drone = copter["id"]
    api.do(drone, type="arm")
    going_on = wait_for("it is recorded", lambda: recording_of(api, drone, "running"), 30)
    tlog = download(api, going_on["id"])
    messages = read(tlog, tmp_path)
    assert len(messages) == records(tlog)
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
