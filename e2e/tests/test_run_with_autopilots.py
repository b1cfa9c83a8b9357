"""A run of three real autopilots: one is killed in the air, the others finish its waypoints."""

import math
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e import sitl
from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import EARTH_RADIUS_METERS
from dronemap_e2e.runs import create_plan, distance, ready_drone, run_if_over, stages, waypoints_in_state
from dronemap_e2e.server import Server
from dronemap_e2e.sitl import Autopilot
from dronemap_e2e.trajectories import Fix, nearest
from dronemap_e2e.trajectories import Track as Way
from dronemap_e2e.waiting import wait_for

FIRST_SYSTEM_ID = 241
DRONES = 3
WAYPOINTS = 15
LATITUDE, LONGITUDE, HOME_AMSL = 47.3977, 8.5456, 488.0
HOMES_APART_METRES = 20
SPACING_METRES = 40
HEIGHT_METRES = 20
NEAR_METRES = 3.0
LEAST_METRES = 10.0
PER_DEGREE = math.radians(1) * EARTH_RADIUS_METERS
EASTWARD_PER_DEGREE = PER_DEGREE * math.cos(math.radians(LATITUDE))


def place(north: float, east: float) -> tuple[float, float]:
    return LATITUDE + north / PER_DEGREE, LONGITUDE + east / EASTWARD_PER_DEGREE


@pytest.fixture
def copters(own_server: Server, tmp_path: Path) -> Iterator[list[Autopilot]]:
    started: list[Autopilot] = []
    try:
        for number in range(DRONES):
            latitude, longitude = place(0, (number - 1) * HOMES_APART_METRES)
            home = f"{latitude:.7f},{longitude:.7f},{HOME_AMSL},0"
            folder = tmp_path / f"copter-{number}"
            started.append(
                Autopilot(sitl.COPTER, folder, own_server.udp_port, FIRST_SYSTEM_ID + number, home)
            )
        yield started
    finally:
        for copter in started:
            copter.close()


def waypoints() -> list[Json]:
    """Five by three, north of the homes."""
    return [
        {
            "latitude": latitude,
            "longitude": longitude,
            "altitude": HOME_AMSL + HEIGHT_METRES,
            "altitudeReference": "amsl",
        }
        for latitude, longitude in (
            place((1 + n % 5) * SPACING_METRES, (n // 5 - 1) * SPACING_METRES) for n in range(WAYPOINTS)
        )
    ]


def local_track(copter: Autopilot) -> Way:
    """In metres about the middle home, by the clock of all."""
    return Way(
        [
            Fix(
                seconds,
                (longitude - LONGITUDE) * EASTWARD_PER_DEGREE,
                (latitude - LATITUDE) * PER_DEGREE,
                amsl - HOME_AMSL,
                amsl - HOME_AMSL,
            )
            for seconds, latitude, longitude, amsl in copter.ground_truth.positions()
        ]
    )


@pytest.mark.soak
@pytest.mark.skipif(sitl.COPTER.binary is None, reason=sitl.COPTER.why_not)
@pytest.mark.parametrize("on_cloud_loss", ["rtl", "continue"])
def test_run_replaces_real_autopilot_killed_in_the_air(
    own_server: Server, copters: list[Autopilot], on_cloud_loss: str
) -> None:
    api = Api(own_server.address, own_server.local_key())
    drones = [
        wait_for("all is known", partial(ready_drone, api, FIRST_SYSTEM_ID + n), 120) for n in range(DRONES)
    ]
    for drone in drones:
        wait_for("it may fly", partial(sitl.arms_and_enters_guided, api, drone["id"]), 90, every=3)
    # The words of a vehicle and its own port tell of the same one.
    by_id = {drone["id"]: copter for drone, copter in zip(drones, copters, strict=True)}
    asked = {"plan": create_plan(api, drones, waypoints()), "onCloudLoss": on_cloud_loss}
    started = api.call("POST", "/runs", asked)
    assert started.status_code == 201, started.text
    run = f"/runs/{started.json()['id']}"
    wait_for("all fly", lambda: set(stages(api.get(run)).values()) == {"flying"}, 120)

    killed = drones[1]["id"]
    wait_for("it has visited one", lambda: waypoints_in_state(api.get(run), killed, "visited"), 120)
    by_id[killed].kill()
    truly = by_id[killed].ground_truth.track()
    left = [
        one["id"]
        for one in waypoints_in_state(api.get(run), killed, "assigned")
        if distance(one, truly) > NEAR_METRES
    ]
    assert truly[-1][2] > HOME_AMSL + HEIGHT_METRES / 2, "it was in the air"
    assert len(left) >= 2, "it had something left to do"
    over = wait_for("it is over", partial(run_if_over, api, run), 480, every=0.5)

    words = [one["words"] for one in over["explanations"]]
    assert over["counts"]["visited"] == WAYPOINTS, words
    for one in over["waypoints"]:
        by = one["visits"][0]["drone"]
        assert distance(one, by_id[by].ground_truth.track()) < NEAR_METRES, (one, words)
        assert by != killed or one["id"] not in left, (one, words)
    lost = next(one for one in over["explanations"] if one["trigger"] == "lost")
    assert lost["drone"] == killed, words
    for drone, copter in by_id.items():
        assert drone == killed or copter.ground_truth.altitude() < HOME_AMSL + 1, "it is down"
    least = nearest({number: local_track(copter) for number, copter in enumerate(copters)})
    print("NEAREST", least, "TAKEN OVER", len(left))
    assert least is None or least.metres >= LEAST_METRES, (least, words)
    assert api.get(f"{run}/journal/replay")["same"]
