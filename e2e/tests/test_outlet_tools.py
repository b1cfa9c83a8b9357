"""Tools of other makers as they are published: they list, read, write and fly through the outlet."""

import json
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api
from dronemap_e2e.copter import PARAMETERS, Copter, ids
from dronemap_e2e.ground_station import GroundStation, User, granted
from dronemap_e2e.mavproxy import Mavproxy
from dronemap_e2e.ports import free_port
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.waiting import throughout, wait_for

Sign = Callable[..., int]
DENIED = 2


@pytest.fixture
def pilot(server: Server, api: Api, copters: list[Copter]) -> Iterator[User]:
    user = granted(server, api, "operator", ids(copters))
    yield user
    for copter in copters:
        user.api.call("DELETE", f"/drones/{copter.id}/control")


@pytest.fixture
def signing_relay(server: Server, tmp_path: Path) -> Iterator[Sign]:
    """Starts a signer towards a port at which a tool listens."""
    started: list[subprocess.Popen[bytes]] = []

    def begin(user: User) -> int:
        port = free_port(socket.SOCK_DGRAM)
        with (tmp_path / "signer.log").open("ab") as log:
            started.append(
                subprocess.Popen(
                    [
                        *(sys.executable, "-m", "dronemap_signing_relay"),
                        *("--server", f"udp:127.0.0.1:{server.outlet_udp_port}", "--to", f"127.0.0.1:{port}"),
                    ],
                    cwd=ROOT / "signing-relay",
                    env=os.environ | {"DRONEMAP_PASSPHRASE": user.passphrase},
                    stdout=log,
                    stderr=log,
                )
            )
        return port

    yield begin
    for process in started:
        process.terminate()
        process.wait(10)


def landed(api: Api, drone: str) -> bool:
    return api.drone(drone)["armed"] is False


def flown_over_the_outlet(api: Api, copters: list[Copter], user: User) -> list[set[str]]:
    """The kinds of commands that each copter was given by that user, all of them there."""
    every = [api.get(f"/drones/{copter.id}/commands")["commands"] for copter in copters]
    own = [[c for c in commands if c["by"] == user.name] for commands in every]
    assert {c["face"] for commands in own for c in commands} == {"outlet"}
    return [{c["type"] for c in commands} for commands in own]


def test_mavsdk_through_signing_relay_with_two_vehicles_of_one_system_id(
    api: Api, copters: list[Copter], pilot: User, signing_relay: Sign
) -> None:
    """End to end because MAVSDK and the signer are foreign programs."""
    port = signing_relay(pilot)
    ended = subprocess.run(
        [sys.executable, "-m", "dronemap_e2e.mavsdk_pilot", f"udpin://127.0.0.1:{port}", str(len(copters))],
        cwd=ROOT / "e2e",
        capture_output=True,
        text=True,
        timeout=180,
    )
    assert ended.returncode == 0, f"{ended.stdout[-3000:]}\n{ended.stderr[-3000:]}"
    report: list[dict[str, Any]] = json.loads(ended.stdout.splitlines()[-1])
    assert len({vehicle["system"] for vehicle in report}) == len(copters)
    assert {vehicle["parameters"] for vehicle in report} == {PARAMETERS}
    assert {vehicle["items"] for vehicle in report} == {0, 6}
    for commands in flown_over_the_outlet(api, copters, pilot):
        assert {"arm", "takeOff", "land"} <= commands
    for copter in copters:
        assert len(copter.recorder.messages("PARAM_REQUEST_LIST", up=False)) <= 1


def test_unsigned_client_at_personal_port_is_read_only(api: Api, copters: list[Copter], pilot: User) -> None:
    """End to end because pymavlink speaks, unsigned, to a port that is really opened and closed."""
    opened = pilot.api.call("POST", "/outlet/ports", {"address": "127.0.0.1", "hours": 1})
    assert opened.status_code == 201, opened.text
    endpoint = opened.json()["endpoint"].removeprefix("udpserver://")
    grounds = [GroundStation(f"udpout:{endpoint}", None)]
    try:
        (first,) = grounds
        numbers = first.wait_vehicles(len(copters))
        assert not any(m.get_signed() for m in first.all_messages)
        grounds.append(GroundStation(f"udpout:{endpoint}", None))
        own = f"/outlet/ports/{opened.json()['id']}"
        wait_for("a second one is counted", lambda: pilot.api.get("/outlet")["ports"][0]["refused"] >= 3)
        assert grounds[1].all_messages == []

        received = [copter.messages_received() for copter in copters]
        for number in numbers:
            first.send_fields("set_mode", number, 1, 4)
            first.send_fields("param_set", number, 1, b"RTL_ALT", 900.0, mavlink.MAV_PARAM_TYPE_REAL32)
            first.send_fields("mission_clear_all", number, 1)
            first.send_fields(
                "command_long", number, 1, mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0, 1, 0, 0, 0, 0, 0, 0
            )
        for number in numbers:

            def refused(number: int = number) -> list[Any]:
                answers = first.messages("COMMAND_ACK", number)
                return [m for m in answers if m.command == mavlink.MAV_CMD_COMPONENT_ARM_DISARM]

            assert [m.result for m in wait_for("it is answered", refused)] == [DENIED]
            first.send_fields("mission_request_list", number, 1)
            wait_for("it is counted", partial(first.messages, "MISSION_COUNT", number))
            first.send_fields("mission_request_int", number, 1, 0)
            home = wait_for("home is item 0", partial(first.messages, "MISSION_ITEM_INT", number))
            assert (home[0].seq, home[0].frame) == (0, 0)
        assert [copter.messages_received() for copter in copters] == received

        assert pilot.api.call("DELETE", own).status_code == 204
        wait_for("it is closed", lambda: not pilot.api.get("/outlet")["ports"])
        closed = len(first.all_messages)
        first.send_fields("heartbeat", 6, 8, 0, 0, 4)
        throughout("nothing more comes", lambda: len(first.all_messages) <= closed + 20, 1)
    finally:
        for ground in grounds:
            ground.close()


@pytest.mark.soak
def test_mavproxy_with_two_vehicles_of_one_system_id(
    server: Server, api: Api, copters: list[Copter], pilot: User, tmp_path: Path
) -> None:
    program = shutil.which("mavproxy.py") or os.environ.get("DRONEMAP_MAVPROXY")
    if program is None:
        pytest.skip(
            "DRONEMAP_MAVPROXY names no mavproxy.py, which is not installed: it brings 900 MB of libraries"
        )
    for copter in copters:
        home = api.drone(copter.id)["home"]
        place = {"latitude": home["latitude"] + 2e-4, "longitude": home["longitude"], "altitude": 20}
        items = [
            {"type": "takeOff", "altitude": 20},
            {"type": "waypoint", **place},
            {"type": "waypoint", **place},
        ]
        assert api.do(copter.id, type="uploadMission", items=items)
        assert api.call("DELETE", f"/drones/{copter.id}/control").ok
    proxy = Mavproxy(program, f"udpout:127.0.0.1:{server.outlet_udp_port}", tmp_path)
    try:
        proxy.enter(f"signing key {pilot.passphrase}")
        proxy.wait("Received 1000 parameters", 60)
        for number in (1, 2):
            proxy.enter(f"vehicle {number}")
            proxy.wait(f"Set vehicle {number}")
            proxy.enter("wp list")
            # Home stands before the three.
            proxy.wait("Requesting 4 waypoints")
            proxy.wait("Saved waypoints to")
            proxy.enter("mode GUIDED")
            proxy.wait("DO_SET_MODE: ACCEPTED")
            proxy.enter("arm throttle")
            proxy.wait("COMPONENT_ARM_DISARM: ACCEPTED")
            proxy.enter("takeoff 8")
            proxy.wait("NAV_TAKEOFF: ACCEPTED")
            copter = wait_for("one flies", lambda: [c for c in copters if api.drone(c.id)["armed"]])[0]
            proxy.enter("mode LAND")
            proxy.wait("DO_SET_MODE: ACCEPTED")
            wait_for("it is down", partial(landed, api, copter.id), 60)
    finally:
        proxy.close()
    for commands in flown_over_the_outlet(api, copters, pilot):
        assert {"arm", "setMode", "takeOff"} <= commands
