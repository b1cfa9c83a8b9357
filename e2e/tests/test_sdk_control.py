"""Programs that leave their drone in the air, each in its own way, judged from the wire alone."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.flight import ARMED, COPTER_RTL, Point
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

COPTER_LAND = 9
AWAY_METERS = 25.0

BEGIN = """
import sys, time
from dronemap import Dronemap
with Dronemap.connect() as server:
    drone = server.drone(sys.argv[1])
    home = drone.state.home
    with drone.control({how}) as pilot:
        pilot.arm()
        pilot.take_off(8)
        pilot.go_to(home.latitude + 0.00027, home.longitude, 8)
        print("there", flush=True)
        {end}
"""
# What each program says of leaving, and what it does when its drone is 30 m away.
PROGRAMS = {
    "leaves": BEGIN.format(how="", end="pass"),
    "fails": BEGIN.format(how="", end="raise ZeroDivisionError('of the program')"),
    "is interrupted": BEGIN.format(how="", end="time.sleep(3600)"),
    "is killed": BEGIN.format(how="", end="time.sleep(3600)"),
    "lands": BEGIN.format(how="on_exit='land'", end="pass"),
    "holds": BEGIN.format(how="on_exit='hold'", end="pass"),
    "keeps": BEGIN.format(how="on_exit='keep'", end="pass"),
}
SIGNALS = {"is interrupted": signal.SIGINT, "is killed": signal.SIGKILL}


@dataclass
class Flown:
    """What became of one program and of its drone."""

    wire: VehicleMessages
    home: Point
    status: int
    errors: str
    called_home_by: list[str]
    """Who gave each command to return."""

    def modes(self) -> list[int]:
        """The modes that the vehicle had, in order."""
        told = [
            h.message.custom_mode
            for h in self.wire.messages("HEARTBEAT", up=True)
            if h.message.get_srcComponent() == 1
        ]
        return [mode for i, mode in enumerate(told) if i == 0 or told[i - 1] != mode]

    def landed_from_home(self) -> float:
        last = self.wire.messages("GLOBAL_POSITION_INT", up=True)[-1].message
        assert last.relative_alt / 1000 < 1, "it did not land"
        return self.home.metres_to(last.lat / 1e7, last.lon / 1e7)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Flown]]:
    folder = tmp_path_factory.mktemp("control")
    # A shell lets what it runs in the background ignore interruptions, and programs would inherit that.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    server = Server(
        folder / "data",
        DRONEMAP_CONTROL_LOST_SECONDS="3",
        DRONEMAP_CONTROL_RETURN_SECONDS="2",
        DRONEMAP_CONTROL_IDLE_SECONDS="3",
    )
    server.start()
    vehicles = Vehicles(server, folder / "sim.log")
    try:
        yield fly(server, vehicles, folder)
    finally:
        vehicles.close()
        server.stop()
        signal.signal(signal.SIGINT, before)


def fly(server: Server, vehicles: Vehicles, folder: Path) -> dict[str, Flown]:
    api = Api(server.address, server.local_key())
    awake = {case: vehicles.wake_next() for case in PROGRAMS}
    wait_for("the copters are ready", lambda: all([api.ready(each) for each in awake.values()]), 90)
    drones = {case: api.ready(system_id) for case, system_id in awake.items()}
    environment = os.environ | {
        "DRONEMAP_URL": server.address,
        "DRONEMAP_KEY": server.local_key(),
        "PYTHONPATH": str(ROOT / "sdk-python"),
    }
    programs = {}
    for case, text in PROGRAMS.items():
        drone = drones[case]
        assert drone is not None
        programs[case] = subprocess.Popen(
            [sys.executable, "-c", text, drone["id"]],
            env=environment,
            cwd=folder,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
    ended = {}
    for case, program in programs.items():
        assert program.stdout is not None
        said = program.stdout.readline()
        assert said == "there\n", program.communicate()[1]
        if case in SIGNALS:
            program.send_signal(SIGNALS[case])
        errors = program.communicate(timeout=60)[1]
        drone = drones[case]
        assert drone is not None
        home = Point(drone["home"]["latitude"], drone["home"]["longitude"], 0)
        ended[case] = Flown(vehicles.wire(awake[case]), home, program.returncode, errors, [])
    wait_for(
        "all are down and disarmed",
        lambda: all(not is_armed(each.wire) for each in ended.values()),
        seconds=120,
    )
    for case, flown in ended.items():
        drone = drones[case]
        assert drone is not None
        given = api.get(f"/drones/{drone['id']}/commands")["commands"]
        flown.called_home_by = [each["by"] for each in given if each["type"] == "returnToLaunch"]
    return ended


def is_armed(wire: VehicleMessages) -> bool:
    beats = [h for h in wire.messages("HEARTBEAT", up=True) if h.message.get_srcComponent() == 1]
    return bool(beats[-1].message.base_mode & ARMED)


@pytest.mark.parametrize("case", ["leaves", "fails", "is interrupted"])
def test_drone_of_a_program_that_ends_its_block_returns_home(flown: dict[str, Flown], case: str) -> None:
    """End to end because programs end in earnest, and the judge sees only the wire."""
    ended = flown[case]
    assert ended.modes()[-1] == COPTER_RTL
    assert ended.landed_from_home() < 2
    assert ended.called_home_by == ["admin"]
    assert (ended.status == 0) == (case == "leaves")
    if case == "fails":
        assert "ZeroDivisionError: of the program" in ended.errors


def test_drone_of_a_killed_program_is_called_home_by_the_server(flown: dict[str, Flown]) -> None:
    """End to end because a program of its own is killed, and the judge sees only the wire."""
    ended = flown["is killed"]
    assert ended.status == -signal.SIGKILL
    assert ended.called_home_by
    assert "admin" not in ended.called_home_by
    assert ended.modes()[-1] == COPTER_RTL
    assert ended.landed_from_home() < 2


def test_drone_lands_where_it_is_when_it_was_said_so(flown: dict[str, Flown]) -> None:
    """End to end because a program of its own is left, and the judge sees only the wire."""
    ended = flown["lands"]
    assert ended.status == 0, ended.errors
    assert ended.modes()[-1] == COPTER_LAND
    assert COPTER_RTL not in ended.modes()
    assert ended.landed_from_home() > AWAY_METERS


@pytest.mark.parametrize("case", ["holds", "keeps"])
def test_drone_that_is_left_hovering_is_called_home_by_the_server(flown: dict[str, Flown], case: str) -> None:
    """End to end because a program of its own is left, and the judge sees only the wire."""
    ended = flown[case]
    assert ended.status == 0, ended.errors
    assert ended.called_home_by
    assert "admin" not in ended.called_home_by
    assert ended.modes()[-1] == COPTER_RTL
    assert ended.landed_from_home() < 2
