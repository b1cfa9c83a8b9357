"""Recordings of real vehicles, played at ten times their speed."""

import os
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.waiting import wait_for

DATA = os.environ.get("DRONEMAP_TEST_DATA")
GOOD_MESSAGES = {
    "ardusub_small.tlog": 35_912,
    "mavlinkserver_00025.tlog": 30_439,
    "ardusub_pymavlink_bug_2023-04-18.tlog": 50_136,
}

# The others never had a fix.
WITH_POSITION = {"ardusub_small.tlog"}

pytestmark = pytest.mark.skipif(DATA is None, reason="DRONEMAP_TEST_DATA is not set")


@pytest.fixture(params=GOOD_MESSAGES)
def recording(request: pytest.FixtureRequest) -> Path:
    name: str = request.param
    return Path(str(DATA)) / "tlogs" / name


def test_a_recording_shows_its_vehicle_and_loses_no_good_message(api: Api, recording: Path) -> None:
    answer = api.post_bytes(f"/replays?speed=10&name={recording.name}", recording.read_bytes())
    assert answer.status_code == 202, answer.text
    replay = answer.json()["id"]

    drone = wait_for("its drone is listed", lambda: drone_of(api, replay), 30)

    assert drone["replay"] is True
    assert (drone["kind"], drone["autopilot"], drone["vehicle"]) == ("submarine", "ArduPilot", "ArduSub")
    moving = wait_for("mode and battery are shown", lambda: shown(api, drone["id"]), 20)
    assert moving["mode"] in {"MANUAL", "STABILIZE", "ALT_HOLD", "POSHOLD", "SURFACE", "ACRO"}
    refused = api.call("POST", f"/drones/{drone['id']}/commands", {"type": "arm"})
    assert refused.status_code == 409 and "recording" in refused.json()["detail"]
    done = wait_for("it was played to its end", lambda: finished(api, replay), 120)
    assert done["goodMessages"] == GOOD_MESSAGES[recording.name]
    position = api.drone(drone["id"])["position"] or {"latitude": None}
    assert (position["latitude"] is not None) == (recording.name in WITH_POSITION)
    assert len(done["drones"]) == 1, "other components make no drone"
    wait_for("its drone is called ended, not lost", lambda: is_ended(api, drone["id"]), 10)
    api.call("DELETE", f"/replays/{replay}")


def drone_of(api: Api, replay: str) -> Json | None:
    drones = api.get(f"/replays/{replay}")["drones"]
    return api.drone(drones[0]) if drones else None


def shown(api: Api, drone: str) -> Json | None:
    now = api.drone(drone)
    return now if now["mode"] and now["battery"] and now["battery"]["volts"] else None


def is_ended(api: Api, drone: str) -> bool:
    return bool(api.drone(drone)["link"]["state"] == "ended")


def finished(api: Api, replay: str) -> Json | None:
    now = api.get(f"/replays/{replay}")
    return now if now["state"] == "finished" else None
