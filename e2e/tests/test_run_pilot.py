"""A pilot takes a drone out of a mission run; another one, whose home lies far below, flies its waypoints."""

import time
from collections.abc import Iterator
from functools import partial

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.message_recorder import MessageRecorder, RecordedMessage
from dronemap_e2e.runs import (
    Track,
    create_plan,
    distance,
    ready_drone,
    run_if_over,
    stages,
    tracks,
    waypoints_in_state,
)
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

VALLEY, MOUNTAIN = 221, 222
# Metres above the sea: the homes, and the lowest waypoint.
VALLEY_AMSL, MOUNTAIN_AMSL, LOWEST_AMSL = 488, 568, 590
LATITUDE, LONGITUDE, EASTWARD = 47.3977, 8.5456, 0.0016
LOITER = 5
WAYPOINTS = 8
NEAR_METRES = 5.0
HEIGHT_METRES = 1.0
REQUESTS = {511, 512, 519, 520}
ORDERS = (
    *("COMMAND_LONG", "COMMAND_INT", "SET_MODE", "PARAM_SET", "MANUAL_CONTROL", "RC_CHANNELS_OVERRIDE"),
    *("MISSION_COUNT", "MISSION_ITEM_INT", "MISSION_CLEAR_ALL", "MISSION_SET_CURRENT"),
    *("SET_POSITION_TARGET_GLOBAL_INT", "SET_POSITION_TARGET_LOCAL_NED"),
)


@pytest.fixture
def recorder(server: Server) -> Iterator[MessageRecorder]:
    opened = MessageRecorder(server.udp_port)
    yield opened
    opened.close()


@pytest.fixture
def simulator(recorder: MessageRecorder, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Simulator]:
    """The simulator of the drone on the mountain; beside it one of the drone in the valley."""
    both = [
        Simulator(
            tmp_path_factory.mktemp("depots") / "sim.log",
            f"udp://127.0.0.1:{recorder.port}",
            *("--speedup", "5", "--sysid", str(system_id)),
            *("--home", f"{LATITUDE},{LONGITUDE + n * EASTWARD},{amsl}"),
        )
        for n, (system_id, amsl) in enumerate(((VALLEY, VALLEY_AMSL), (MOUNTAIN, MOUNTAIN_AMSL)))
    ]
    yield both[1]
    for one in both:
        one.stop()


def waypoints() -> list[Json]:
    """A row of them to the north of both homes, each a little higher than the one before."""
    return [
        {
            "latitude": LATITUDE + 0.0004,
            "longitude": LONGITUDE + n * EASTWARD / (WAYPOINTS - 1),
            "altitude": LOWEST_AMSL + 2 * n,
            "altitudeReference": "amsl",
        }
        for n in range(WAYPOINTS)
    ]


def commands_sent(recorder: MessageRecorder, system_id: int, since: float) -> list[RecordedMessage]:
    """Orders to that vehicle; requests for messages do not count."""
    return [
        recorded
        for recorded in recorder.messages(*ORDERS, up=False, since=since)
        if recorded.message.target_system == system_id
        and not (recorded.kind == "COMMAND_LONG" and recorded.message.command in REQUESTS)
    ]


def off_height(waypoint: Json, track: Track) -> float:
    """Metres too high or too low at the point nearest to the waypoint over ground."""
    nearest = min(track, key=lambda at: distance({**waypoint, "altitudeAmsl": at[2]}, [at]))
    off: float = abs(nearest[2] - waypoint["altitudeAmsl"])
    return off


@pytest.mark.soak
def test_drone_taken_by_pilot_is_replaced_at_same_height_and_not_commanded(
    api: Api, recorder: MessageRecorder, simulator: Simulator
) -> None:
    drones = [wait_for("all is known", partial(ready_drone, api, one), 120) for one in (VALLEY, MOUNTAIN)]
    stays, leaves = (drone["id"] for drone in drones)
    assert drones[1]["home"]["altitudeAmsl"] - drones[0]["home"]["altitudeAmsl"] == pytest.approx(80, abs=1)
    asked = api.call(
        "POST", "/runs", {"plan": create_plan(api, drones, waypoints()), "onCloudLoss": "continue"}
    )
    assert asked.status_code == 201, asked.text
    run = f"/runs/{asked.json()['id']}"
    wait_for("it is on its way", lambda: waypoints_in_state(api.get(run), leaves, "visited"), 180)

    simulator.fault(f"{MOUNTAIN} mode {LOITER}")
    wait_for("the pilot has it", lambda: stages(api.get(run))[leaves] == "suspended", 30)
    since = time.monotonic()
    left = wait_for(
        "the other one has all",
        lambda: next((d["next"] for d in api.get(run)["drones"] if d["id"] == stays and d["next"]), None),
        30,
    )
    wait_for("the other one has done what it can", lambda: stages(api.get(run))[stays] == "landed", 240)

    flown = tracks(recorder, drones, VALLEY)
    ends = api.get(run)
    by_other = [one for one in ends["waypoints"] if one["id"] in left and one["state"] == "visited"]
    # Where the pilot hovers nobody may go meanwhile.
    waiting = [one for one in ends["waypoints"] if one["state"] != "visited"]
    assert all("stands in the air there" in one["why"] for one in waiting), waiting
    assert by_other, ends["explanations"]
    for one in by_other:
        assert distance(one, flown[stays]) < NEAR_METRES, one
        assert off_height(one, flown[stays]) < HEIGHT_METRES, (one, off_height(one, flown[stays]))
    assert commands_sent(recorder, MOUNTAIN, since) == []
    assert api.drone(leaves)["mode"] == "LOITER"
    words = [one for one in ends["explanations"] if one["trigger"] == "takenOver"]
    assert words and words[0]["drone"] == leaves, ends["explanations"]

    resumed = api.call("POST", f"{run}/drones/{leaves}/resume")
    assert resumed.ok, resumed.text
    over = wait_for("it is over", partial(run_if_over, api, run), 240)
    assert over["counts"]["visited"] == WAYPOINTS, over["explanations"]
    assert commands_sent(recorder, MOUNTAIN, since)
    assert api.get(f"{run}/journal/replay")["same"]
