"""A phone is followed by a simulated copter."""

import math
import statistics
import time
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
import zeep.exceptions

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point
from dronemap_e2e.message_recorder import MessageRecorder
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import rounds, wait_for

SYSTEM_ID = 91
METRES_PER_DEGREE = 111_195
WALKS = 1.4
DISTANCE = 6
HEIGHT = 10
FACE = 1.5
SECONDS = 30
SETTLED = 15


@pytest.fixture
def simulator(recorder: MessageRecorder, tmp_path: Path) -> Iterator[Simulator]:
    """One copter with a gimbal. It lives as fast as the phone: speeds count."""
    options = ["--count", "1", "--sysid", str(SYSTEM_ID), "--parameter", "MNT1_TYPE=1"]
    started = Simulator(tmp_path / "sim.log", f"udp://127.0.0.1:{recorder.port}", *options)
    yield started
    started.stop()


@pytest.fixture
def drone(simulator: Simulator, api: Api) -> Json:
    """The drone that stands ready."""
    return wait_for("the copter is ready", lambda: api.ready(SYSTEM_ID), 90)


def gimbal_pitch(simulator: Simulator) -> float:
    """Degrees that the camera truly looks above the horizon."""
    return float(simulator.payload(SYSTEM_ID).rpartition("gimbal ")[2])


class WalkingPhone:
    """A phone that walks east from near the drone's home, and sends its position once a second."""

    def __init__(self, api: Api, home: Json) -> None:
        self._api = api
        self._home = home
        self._started = time.time()
        self._sent_at = 0.0
        self.follow = ""

    def position(self, at: float, east: float = 0.0) -> Point:
        metres = WALKS * (at - self._started) + east
        across = METRES_PER_DEGREE * math.cos(math.radians(self._home["latitude"]))
        latitude = self._home["latitude"] + 15 / METRES_PER_DEGREE
        return Point(latitude, self._home["longitude"] + metres / across, HEIGHT)

    def send_position(self) -> None:
        now = time.time()
        if now - self._sent_at < 1:
            return
        self._sent_at = now
        at = datetime.fromtimestamp(now, UTC).isoformat()
        here = self.position(now)
        position = {"at": at, "latitude": here.latitude, "longitude": here.longitude, "accuracy": 4}
        answer = self._api.call(
            "POST", f"/follows/{self.follow}/positions", {"sent": at, "positions": [position]}
        )
        assert answer.ok, answer.text

    def send_positions_until(self, state: str, seconds: float) -> Json:
        def reached() -> Json | None:
            self.send_position()
            seen = self._api.get(f"/follows/{self.follow}")
            return seen if seen["state"] == state else None

        return wait_for(f"the follow is {state}", reached, seconds)


@pytest.mark.soak
def test_copter_follows_a_phone_and_returns_home(
    api: Api, recorder: MessageRecorder, simulator: Simulator, drone: Json
) -> None:
    phone = WalkingPhone(api, drone["home"])
    here = phone.position(time.time())
    order = {
        "latitude": here.latitude,
        "longitude": here.longitude,
        "drone": drone["id"],
        "place": {"side": "behind", "distance": DISTANCE, "height": HEIGHT},
    }
    answer = api.call("POST", "/follows", order)
    assert answer.status_code == 201, answer.text
    phone.follow = answer.json()["id"]
    assert api.call("POST", f"/follows/{phone.follow}/start").ok
    phone.send_positions_until("tracking", 60)

    errors = []
    began = time.time()
    for _ in rounds(time.monotonic() + SECONDS, 0.2):
        phone.send_position()
        now = time.time()
        message = recorder.messages("GLOBAL_POSITION_INT", up=True)[-1].message
        if now - began > SETTLED:
            wanted = phone.position(now, east=-DISTANCE)
            errors.append(wanted.metres_to(message.lat / 1e7, message.lon / 1e7))
            assert abs(message.relative_alt / 1000 - HEIGHT) < 2
    assert statistics.fmean(errors) < 2, errors
    face = -math.degrees(math.atan2(HEIGHT - FACE, DISTANCE))
    assert abs(gimbal_pitch(simulator) - face) < 8, f"{gimbal_pitch(simulator)} and not {face}"

    assert api.call("POST", f"/follows/{phone.follow}/pause").ok
    phone.send_positions_until("paused", 5)
    assert api.call("POST", f"/follows/{phone.follow}/stop").ok
    over = phone.send_positions_until("over", 120)
    assert "is down" in over["end"], over
    assert gimbal_pitch(simulator) == 0, "the camera was not let go"


def test_follow_by_zeep_soap_client(server: Server, copter: Json) -> None:
    """End to end because zeep calls and reads answers by the WSDL of the follower service alone."""
    service = soap(server, server.local_key(), "FollowerService")
    home = copter["home"]
    latitude, longitude = home["latitude"] + 20 / METRES_PER_DEGREE, home["longitude"]

    allocated = service.followRequest(
        drone=copter["id"],
        latitude=latitude,
        longitude=longitude,
        place={"side": "fixed", "bearing": 180, "distance": 5, "height": 5},
    )
    assert (allocated.state, allocated.drone) == ("allocated", copter["id"]), allocated
    with pytest.raises(zeep.exceptions.Fault, match="has not been started"):
        service.stopTracking(followId=allocated.id)
    assert service.startTracking(followId=allocated.id).state == "starting"

    def comes() -> Any:
        now = datetime.now(UTC)
        position = {"at": now, "latitude": latitude, "longitude": longitude, "accuracy": 4.0}
        service.sendNewGPSLocation(followId=allocated.id, sent=now, positions={"item": [position]})
        seen = service.getFollow(followId=allocated.id)
        return seen if seen.state == "tracking" and seen.now.distance < 15 else None

    wait_for("the drone has come", comes, 40)
    assert service.disableTracking(followId=allocated.id).state == "paused"
    assert service.enableTracking(followId=allocated.id).state == "starting"
    wait_for("it follows again", comes, 10)
    assert service.stopTracking(followId=allocated.id).state == "returning"
    assert service.getFollow(followId=allocated.id).state in ("returning", "over")
