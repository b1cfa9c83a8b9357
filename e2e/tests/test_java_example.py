"""The two programs of the Java example, built outside the tree from what the server serves."""

import subprocess
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import pytest

from dronemap_e2e import java_example
from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point
from dronemap_e2e.java_example import JavaExample
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.server import Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

PROGRAMS = ("FlyByRest", "FlyBySoap")
OF_FLIGHT = ("arm", "takeOff", "goTo", "returnToLaunch")
METERS_PER_DEGREE = 111_195.0


@dataclass
class Flown:
    """One flight by one program: what it ended with, and what its copter told meanwhile."""

    done: "subprocess.CompletedProcess[str]"
    drone: Json
    wire: VehicleMessages


@pytest.fixture(scope="module")
def example(server: Server) -> JavaExample:
    return java_example.built(server)


@pytest.fixture(scope="module")
def flights(example: JavaExample, server: Server, api: Api, vehicles: Vehicles) -> Iterator[dict[str, Flown]]:
    """Both at once, each with a copter of its own, which it is told by name or by id."""
    awake = {program: vehicles.wake_next() for program in PROGRAMS}

    def fly(program: str, system_id: int) -> Flown:
        drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)
        named = drone["name"] if program == "FlyByRest" else drone["id"]
        done = example.run(program, server, server.local_key(), named)
        return Flown(done, drone, vehicles.wire(system_id))

    with ThreadPoolExecutor(len(awake)) as pool:
        under_way = {program: pool.submit(fly, program, system_id) for program, system_id in awake.items()}
    yield {program: flown.result() for program, flown in under_way.items()}
    for system_id in awake.values():
        vehicles.silence(system_id)


@pytest.mark.parametrize("program", PROGRAMS)
def test_example_flies_a_leg_and_comes_home(flights: dict[str, Flown], api: Api, program: str) -> None:
    """End to end because a program is built from what a server serves, and flies a copter."""
    flown = flights[program]
    assert flown.done.returncode == 0, flown.done.stdout + flown.done.stderr
    assert flown.done.stderr == ""
    home = flown.drone["home"]
    north = Point(home["latitude"] + 30 / METERS_PER_DEGREE, home["longitude"], 10)
    track = [seen.message for seen in flown.wire.messages("GLOBAL_POSITION_INT", up=True)]
    assert any(
        north.metres_to(seen.lat / 1e7, seen.lon / 1e7) < 2
        and seen.relative_alt / 1000 == pytest.approx(north.altitude, abs=1)
        for seen in track
    )
    start = Point(home["latitude"], home["longitude"], 0)
    assert start.metres_to(track[-1].lat / 1e7, track[-1].lon / 1e7) < 2
    assert track[-1].relative_alt / 1000 < 1
    now = api.drone(flown.drone["id"])
    assert (now["armed"], now["flight"], now["control"]["state"]) == (False, "onGround", "free")
    assert outcomes(api, flown.drone["id"]) == [
        ("arm", "succeeded"),
        ("takeOff", "succeeded"),
        ("goTo", "succeeded"),
        ("returnToLaunch", "succeeded"),
    ]


@pytest.mark.parametrize("program", PROGRAMS)
def test_refused_command_ends_example_with_the_servers_sentence(
    example: JavaExample, server: Server, api: Api, copter: Json, program: str
) -> None:
    """End to end because a program is told by a server that its command is refused."""
    api.do(copter["id"], type="arm")
    done = example.run(program, server, server.local_key(), copter["id"])
    refused = api.get(f"/drones/{copter['id']}/commands")["commands"][0]
    assert (refused["type"], refused["outcome"]["result"]) == ("arm", "refused")
    assert done.returncode == 1
    assert done.stderr == f"refused: {refused['outcome']['reason']} [{refused['outcome']['code']}]\n"
    assert api.drone(copter["id"])["control"]["state"] == "free"


@pytest.mark.parametrize("program", PROGRAMS)
def test_example_that_fails_in_the_air_calls_its_drone_home(
    example: JavaExample, server: Server, api: Api, copter: Json, program: str
) -> None:
    """End to end because a program gives up in the air, and its copter is to come home."""
    home = copter["home"]
    area = {"type": "Point", "coordinates": [home["longitude"], home["latitude"]], "radius": 15}
    narrow = {"label": "near home", "role": "operator", "area": area}
    key = api.call("POST", "/access-keys", narrow).json()["key"]
    done = example.run(program, server, key, copter["id"])
    assert done.returncode == 1
    *before, failed, last = outcomes(api, copter["id"])
    assert before == [("arm", "succeeded"), ("takeOff", "succeeded")]
    assert failed == ("goTo", "refused")
    assert last == ("returnToLaunch", "succeeded")
    assert done.stderr.startswith("refused: ")
    assert api.drone(copter["id"])["control"]["state"] == "free"
    wait_for("it landed", lambda: api.drone(copter["id"])["armed"] is False, 60)


@pytest.mark.parametrize("program", PROGRAMS)
def test_bad_key_ends_example_with_the_servers_sentence(
    example: JavaExample, server: Server, program: str
) -> None:
    """End to end because a program is told by a server that its key is none."""
    told = Api(server.address, "no-key-at-all").call("GET", "/drones").json()
    done = example.run(program, server, "no-key-at-all")
    assert done.returncode == 1
    assert done.stderr == f"{told['detail']} [{told['code']}]\n"


def outcomes(api: Api, drone: str) -> list[tuple[str, str]]:
    """Of the drone's commands in their order, but for what the server, or a mode of before, made needed."""
    given = api.get(f"/drones/{drone}/commands")["commands"]
    return [
        (command["type"], command["outcome"]["result"])
        for command in reversed(given)
        if command["type"] in OF_FLIGHT
    ]
