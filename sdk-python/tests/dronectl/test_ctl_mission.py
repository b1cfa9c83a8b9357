"""Missions: flown, and read from the files of other programs."""

import asyncio
import json
import os
import signal
from pathlib import Path
from typing import Any

import contract_samples as samples
import pytest
from fake_server import FakeServer, Members, command, drone, run

from dronectl.failure import BadFile
from dronectl.mission_file import read_mission
from dronemap.contract.models import (
    LandItem,
    LookAheadItem,
    LookAtItem,
    ReturnToLaunchItem,
    SetServoItem,
    TakeOffItem,
    TakePhotoItem,
    WaitItem,
    WaypointItem,
)

HAS = {"reached": [], "running": False, "items": samples.ITEMS, "current": 2, "total": 3}


@pytest.fixture
def server() -> FakeServer:
    return FakeServer(drones=[drone(mission=HAS)])


@pytest.fixture
def file(tmp_path: Path) -> str:
    file = tmp_path / "mission.json"
    file.write_text(json.dumps({"items": samples.ITEMS}))
    return str(file)


def flies(server: FakeServer, given: Members) -> None:
    """Flies its mission when it is started, and comes to its end a moment later."""
    if given["type"] == "arm":
        server.fly(armed=True)
    if given["type"] == "startMission":
        server.fly(flight="inAir", mission=HAS | {"state": "running"})
        over = {"mission": HAS | {"state": "complete"}}
        asyncio.get_running_loop().call_later(0.05, lambda: server.fly(**over))


def test_flies_the_mission_of_a_file(server: FakeServer, file: str) -> None:
    server.on_command = flies
    result = run(server, "mission", "fly", file, "--on-cloud-loss", "rtl")
    assert (result.exit_code, result.stderr) == (0, "")
    given = server.commands()
    assert [one["type"] for one in given] == ["uploadMission", "arm", "startMission"]
    assert given[0]["items"] == samples.ITEMS
    assert given[2]["onCloudLoss"] == "rtl"


def test_end_of_the_mission_before_is_not_taken_for_this_one(server: FakeServer) -> None:
    server.drones = [drone(armed=True, mission=HAS | {"state": "complete"})]
    seen: list[str] = []

    def starts(server: FakeServer, given: Members) -> None:
        loop = asyncio.get_running_loop()
        loop.call_later(0.2, says, "running")
        loop.call_later(0.4, says, "complete")

    def says(state: str) -> None:
        seen.append(state)
        server.fly(flight="inAir", mission=HAS | {"state": state})

    server.on_command = starts
    assert run(server, "mission", "start").exit_code == 0
    assert seen == ["running", "complete"]


def test_drone_that_is_armed_is_not_armed_again(server: FakeServer) -> None:
    server.drones = [drone(armed=True, mission=HAS)]
    server.on_command = flies
    assert run(server, "mission", "start").exit_code == 0
    assert [given["type"] for given in server.commands()] == ["startMission"]


def test_interrupted_mission_holds(server: FakeServer, file: str) -> None:
    def interrupts(server: FakeServer, given: Members) -> None:
        if given["type"] == "arm":
            server.fly(armed=True)
        if given["type"] == "startMission":
            os.kill(os.getpid(), signal.SIGINT)

    server.on_command = interrupts
    result = run(server, "mission", "fly", file)
    assert result.exit_code == 130
    assert server.commands()[-1]["type"] == "hold"


def test_interrupted_upload_leaves_the_drone_alone(server: FakeServer, file: str) -> None:
    server.on_command = lambda server, given: os.kill(os.getpid(), signal.SIGINT)
    result = run(server, "mission", "fly", file)
    assert result.exit_code == 130
    assert [given["type"] for given in server.commands()] == ["uploadMission"]


@pytest.mark.parametrize(
    ("args", "kind"),
    [(["pause"], "pauseMission"), (["clear", "--yes"], "clearMission"), (["start", "--no-wait"], "startMission")],
)
def test_mission_on_the_drone(server: FakeServer, args: list[str], kind: str) -> None:
    assert run(server, "mission", *args).exit_code == 0
    assert server.commands()[-1]["type"] == kind


def test_downloaded_mission_can_be_uploaded(server: FakeServer, tmp_path: Path) -> None:
    to = tmp_path / "down.json"
    assert run(server, "mission", "download", str(to)).exit_code == 0
    assert run(server, "mission", "upload", str(to)).exit_code == 0
    assert server.commands()[0]["items"] == samples.ITEMS


def test_mission_that_nobody_knows(server: FakeServer) -> None:
    server.drones = [drone()]
    for args in (["show"], ["download"]):
        result = run(server, "mission", *args)
        assert result.exit_code == 1
        assert "is not known" in result.stderr


def test_show_marks_the_item_that_is_flown(server: FakeServer) -> None:
    # The contract counts from 0, people from 1.
    assert "3 <" in run(server, "mission", "show").stdout


def test_refused_mission_is_not_flown(server: FakeServer, file: str) -> None:
    server.answers["POST /drones/d1/commands"] = lambda asked: command(
        "uploadMission", id=asked.body["id"], result="failed"
    )
    assert run(server, "mission", "fly", file).exit_code == 1
    assert [given["type"] for given in server.commands()] == ["uploadMission"]


def test_misspelt_member_is_not_passed_over(server: FakeServer, tmp_path: Path) -> None:
    file = tmp_path / "bad.json"
    file.write_text('[{"type": "wait", "holdSeconds": 3, "hold": 4}]')
    result = run(server, "mission", "upload", str(file))
    assert result.exit_code == 2
    assert "there is no member 0.hold" in result.stderr
    assert server.asked == []


WAYPOINTS = """QGC WPL 110
0\t1\t0\t16\t0\t0\t0\t0\t47.0\t8.0\t400\t1
1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t10\t1
2\t0\t3\t16\t5\t0\t0\t0\t47.1\t8.1\t15\t1
3\t0\t0\t16\t0\t0\t0\t0\t47.2\t8.2\t450\t1
4\t0\t3\t93\t7\t0\t0\t0\t0\t0\t0\t1
5\t0\t3\t203\t0\t0\t0\t0\t1\t0\t0\t1
6\t0\t3\t183\t9\t1500\t0\t0\t0\t0\t0\t1
7\t0\t3\t201\t0\t0\t0\t0\t47.3\t8.3\t0\t1
8\t0\t3\t197\t0\t0\t0\t0\t0\t0\t0\t1
9\t0\t3\t21\t0\t0\t0\t0\t47.4\t8.4\t0\t1
"""


def test_reads_waypoints_of_mission_planner(tmp_path: Path) -> None:
    file = tmp_path / "a.waypoints"
    file.write_text(WAYPOINTS)
    assert read_mission(file).items == [
        TakeOffItem(altitude=10),
        WaypointItem(latitude=47.1, longitude=8.1, altitude=15, altitude_reference="home", hold_seconds=5),
        WaypointItem(latitude=47.2, longitude=8.2, altitude=450, altitude_reference="amsl"),
        WaitItem(hold_seconds=7),
        TakePhotoItem(),
        SetServoItem(output=9, pulse=1500),
        LookAtItem(latitude=47.3, longitude=8.3, altitude=0, altitude_reference="home"),
        LookAheadItem(),
        # A landing at a place: there as high as before, and down.
        WaypointItem(latitude=47.4, longitude=8.4, altitude=450, altitude_reference="amsl"),
        LandItem(),
    ]


def plan(*items: Any, **further: Any) -> str:
    return json.dumps({"fileType": "Plan", "version": 1, "mission": {"items": items}, **further})


def simple(command: int, *parameters: Any, frame: int = 3) -> dict[str, Any]:
    return {"type": "SimpleItem", "command": command, "frame": frame, "params": list(parameters)}


def test_reads_a_plan_and_tells_what_is_left_out(tmp_path: Path) -> None:
    file = tmp_path / "a.plan"
    file.write_text(
        plan(
            simple(22, 0, 0, 0, None, 47.0, 8.0, 10),
            simple(16, 0, 0, 0, None, 47.1, 8.1, 15),
            simple(20, 0, 0, 0, 0, 0, 0, 0, frame=2),
            geoFence={"circles": [{}], "polygons": []},
            rallyPoints={"points": [[1, 2, 3]]},
        )
    )
    found = read_mission(file)
    assert found.items == [
        TakeOffItem(altitude=10),
        WaypointItem(latitude=47.1, longitude=8.1, altitude=15, altitude_reference="home", hold_seconds=None),
        ReturnToLaunchItem(),
    ]
    assert found.left_out == ["its fence is not taken over", "its rally points are not taken over"]


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("nonsense", "is no JSON"),
        ("{}", "has no items"),
        ('[{"type": "dance"}]', "0"),
        ('[{"type": "takeOff"}]', "altitude"),
        ("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t400\t1\n", "has no mission items"),
        ("QGC WPL 110\n1\t0\t3\t16\t0\n", "line 2 has 5 columns"),
        ("QGC WPL 110\n1\t0\tx\t16\t0\n", "line 2 cannot be read"),
        ("QGC WPL 110\n1\t0\t10\t16\t0\t0\t0\t0\t47\t8\t40\t1\n", "of frame 10"),
        ("QGC WPL 110\n1\t0\t0\t22\t0\t0\t0\t0\t47\t8\t40\t1\n", "must be above home"),
        ("QGC WPL 110\n1\t0\t3\t178\t0\t0\t0\t0\t0\t0\t0\t1\n", "MAVLink command 178"),
        ("QGC WPL 110\n1\t0\t3\t16\t0\t0\t0\t0\t0\t0\t40\t1\n", "it has no place"),
        ("QGC WPL 110\n1\t0\t3\t21\t0\t0\t0\t0\t47\t8\t0\t1\n", "nothing before it says how high"),
        (plan({"type": "ComplexItem", "complexItemType": "survey"}), "item 1 is a survey"),
        (plan(simple(16, 1, 2)), "has 2 parameters instead of 7"),
        (plan(simple(2000, 0, 2, 10, 0, 0, 0, 0)), "MAVLink command 2000"),
        (plan(), "has no mission items"),
    ],
)
def test_file_that_cannot_be_taken_over_is_refused(tmp_path: Path, text: str, why: str) -> None:
    file = tmp_path / "a.waypoints"
    file.write_text(text)
    with pytest.raises(BadFile, match=why):
        read_mission(file)
