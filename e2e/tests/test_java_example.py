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
from dronemap_e2e.newer_server import NewerServer
from dronemap_e2e.server import Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

PROGRAMS = ("FlyByRest", "FlyBySoap")
OF_FLIGHT = ("arm", "takeOff", "goTo", "returnToLaunch")
METERS_PER_DEGREE = 111_195.0


@dataclass
class Flown:
    """One flight by one program: how that ended, and what its copter told meanwhile."""

    done: "subprocess.CompletedProcess[str]"
    drone: Json
    wire: VehicleMessages

    @property
    def home(self) -> Point:
        return Point(self.drone["home"]["latitude"], self.drone["home"]["longitude"], 0)


@pytest.fixture(scope="module")
def example(server: Server) -> JavaExample:
    return java_example.built(server)


@pytest.fixture(scope="module")
def flights(
    example: JavaExample, server: Server, api: Api, vehicles: Vehicles
) -> Iterator[dict[tuple[str, bool], Flown]]:
    """All at once, each with a copter of its own: by each program, once with a key too narrow for it."""
    awake = {(program, narrow): vehicles.wake_next() for program in PROGRAMS for narrow in (False, True)}

    def fly(program: str, narrow: bool, system_id: int) -> Flown:
        drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)
        key = key_near(api, drone["home"]) if narrow else server.local_key()
        named = drone["name"] if program == "FlyByRest" else drone["id"]
        return Flown(example.run(program, server.address, key, named), drone, vehicles.wire(system_id))

    with ThreadPoolExecutor(len(awake)) as pool:
        under_way = {flight: pool.submit(fly, *flight, system_id) for flight, system_id in awake.items()}
    yield {flight: flown.result() for flight, flown in under_way.items()}
    for system_id in awake.values():
        vehicles.silence(system_id)


@pytest.mark.parametrize("program", PROGRAMS)
def test_example_flies_a_leg_and_comes_home(
    flights: dict[tuple[str, bool], Flown], api: Api, program: str
) -> None:
    """End to end because a program is built from what a server serves, and flies a copter."""
    flown = flights[program, False]
    assert (flown.done.returncode, flown.done.stderr) == (0, "")
    home = flown.home
    turn = Point(home.latitude + 30 / METERS_PER_DEGREE, home.longitude, 10)
    track = [seen.message for seen in flown.wire.messages("GLOBAL_POSITION_INT", up=True)]
    assert any(
        turn.metres_to(seen.lat / 1e7, seen.lon / 1e7) < 2
        and seen.relative_alt / 1000 == pytest.approx(turn.altitude, abs=1)
        for seen in track
    )
    last = track[-1]
    assert home.metres_to(last.lat / 1e7, last.lon / 1e7) < 2
    assert last.relative_alt / 1000 < 1
    now = api.drone(flown.drone["id"])
    assert (now["armed"], now["flight"], now["control"]["state"]) == (False, "onGround", "free")
    results = [(command["type"], command["outcome"]["result"]) for command in given(api, flown.drone)]
    assert results == [(kind, "succeeded") for kind in OF_FLIGHT]


@pytest.mark.parametrize("program", PROGRAMS)
def test_example_that_fails_in_the_air_calls_its_drone_home(
    flights: dict[tuple[str, bool], Flown], api: Api, program: str
) -> None:
    """End to end because a program gives up in the air, and its copter is to come home."""
    flown = flights[program, True]
    *_, failed, last = commands = given(api, flown.drone)
    assert [command["type"] for command in commands] == list(OF_FLIGHT)
    assert (failed["outcome"]["result"], last["outcome"]["result"]) == ("refused", "succeeded")
    assert (flown.done.returncode, flown.done.stderr) == (1, sentence(failed))
    assert api.drone(flown.drone["id"])["control"]["state"] == "free"
    wait_for("it landed", lambda: api.drone(flown.drone["id"])["armed"] is False, 60)


@pytest.mark.parametrize("program", PROGRAMS)
def test_refused_command_ends_example_with_the_servers_sentence(
    example: JavaExample, server: Server, api: Api, copter: Json, program: str
) -> None:
    """End to end because a program is told by a server that its command is refused."""
    api.do(copter["id"], type="arm")
    done = example.run(program, server.address, server.local_key(), copter["id"])
    refused = given(api, copter)[-1]
    assert (refused["type"], refused["outcome"]["result"]) == ("arm", "refused")
    assert (done.returncode, done.stderr) == (1, sentence(refused))
    assert api.drone(copter["id"])["control"]["state"] == "free"


@pytest.mark.parametrize("program", PROGRAMS)
def test_bad_key_ends_example_with_the_servers_sentence(
    example: JavaExample, server: Server, program: str
) -> None:
    """End to end because a program is told by a server that its key is none."""
    problem = Api(server.address, "no-key-at-all").call("GET", "/drones").json()
    done = example.run(program, server.address, "no-key-at-all")
    assert (done.returncode, done.stderr) == (1, f"{problem['detail']} [{problem['code']}]\n")


@pytest.mark.parametrize("program", PROGRAMS)
def test_example_reads_what_a_newer_server_adds(
    example: JavaExample, server: Server, copter: Json, program: str
) -> None:
    """End to end because generated classes read answers that have more than what they were generated from."""
    newer = NewerServer(server.http_port)
    try:
        done = example.run(program, newer.address, server.local_key(), "nobody")
    finally:
        newer.close()
    assert newer.changed == 1
    assert (done.returncode, done.stderr) == (1, "There is no drone nobody.\n")


def key_near(api: Api, home: Json) -> str:
    """One that flies no further than 15 m from there."""
    area = {"type": "Point", "coordinates": [home["longitude"], home["latitude"]], "radius": 15}
    made = api.call("POST", "/access-keys", {"label": "near home", "role": "operator", "area": area})
    key: str = made.json()["key"]
    return key


def given(api: Api, drone: Json) -> list[Json]:
    """The drone's commands in their order, but for what the server, or a mode of before, made needed."""
    commands = api.get(f"/drones/{drone['id']}/commands")["commands"]
    return [command for command in reversed(commands) if command["type"] in OF_FLIGHT]


def sentence(refused: Json) -> str:
    outcome = refused["outcome"]
    return f"refused: {outcome['reason']} [{outcome['code']}]\n"
