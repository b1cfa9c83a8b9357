"""The same flight by every face: what is said, what the drone does and what is recorded are the same."""

import re
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from threading import Barrier
from typing import Any

import pytest

from dronemap_e2e import java_example
from dronemap_e2e.api import Api, Json
from dronemap_e2e.faces import (
    SUCCEEDED,
    CommandLineFace,
    Face,
    JavaFace,
    PythonFace,
    RestFace,
    Said,
    SoapFace,
    StreamFace,
    TypeScriptFace,
)
from dronemap_e2e.flight import items, triangle
from dronemap_e2e.ground_station import new_user
from dronemap_e2e.php_face import PhpFace
from dronemap_e2e.server import Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

FACES: dict[str, Callable[[Server, str, Path], Face]] = {
    "REST": lambda server, key, folder: RestFace(server, key),
    "SOAP": lambda server, key, folder: SoapFace(server, key),
    "stream": lambda server, key, folder: StreamFace(server, key),
    "Python": lambda server, key, folder: PythonFace(server, key),
    "TypeScript": lambda server, key, folder: TypeScriptFace(server, key),
    "Java REST": lambda server, key, folder: JavaFace(server, key, "rest"),
    "Java SOAP": lambda server, key, folder: JavaFace(server, key, "soap"),
    "dronectl": CommandLineFace,
    "PHP": PhpFace,
}


@dataclass
class Flown:
    """All that one flight said, showed and left in the record."""

    seen: list[str] = field(default_factory=list)
    said: dict[str, Said] = field(default_factory=dict)
    control: list[Any] = field(default_factory=list)
    states: list[Any] = field(default_factory=list)
    recorded: list[Any] = field(default_factory=list)


@pytest.fixture(scope="module")
def flights(
    server: Server, vehicles: Vehicles, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[dict[str, Flown]]:
    """All at once, each by one face with a copter and a pilot of its own."""
    # Before the flights, which it would slow down.
    java_example.built(server)
    awake = {name: vehicles.wake_next() for name in FACES}
    all_up = Barrier(len(FACES), timeout=180)
    with ThreadPoolExecutor(len(FACES)) as pool:
        under_way = {
            name: pool.submit(flight, name, server, system_id, tmp_path_factory.mktemp("flight"), all_up)
            for name, system_id in awake.items()
        }
    for system_id in awake.values():
        vehicles.silence(system_id)
    yield {name: flown.result() for name, flown in under_way.items()}


def flight(name: str, server: Server, system_id: int, folder: Path, all_up: Barrier) -> Flown:
    api = Api(server.address, server.local_key())
    drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)
    pilot = new_user(server, api, "operator")
    assert api.call("PUT", f"/users/{pilot.name}/only-granted", {"onlyGranted": True}).status_code == 204
    may = {"user": pilot.name, "drones": [drone["id"]]}
    assert api.call("POST", "/grants", may | {"operations": ["view", "plan"]}).status_code == 201
    granted = api.call("POST", "/grants", may | {"operations": ["command"]})
    face = FACES[name](server, pilot.api.new_key("parity", "operator"), folder)
    flown = Flown()
    try:
        flown.seen = ["this drone" if each == drone["id"] else each for each in face.drones()]
        # Programs that start take the time of those that hold control for seconds only.
        all_up.wait()
        fly(face, api, drone, flown, granted.json()["id"])
    except BaseException:
        all_up.abort()
        raise
    finally:
        face.close()
    flown.recorded = recorded(api, drone, pilot.name)
    flown.said = {step: nameless(said, drone, pilot.name) for step, said in flown.said.items()}
    return flown


def fly(face: Face, api: Api, drone: Json, flown: Flown, grant: str) -> None:
    """Control, arm, take off, mission, return, a refusal, bad input, a revoked grant."""
    id = drone["id"]
    for operation in ("takeControl", "releaseControl"):
        told = face.control(id, operation)
        flown.control.append((told["state"], told["explicit"], told["holder"] is None))
    flown.said["arm"] = face.command(id, {"type": "arm"})
    flown.said["take off"] = face.command(id, {"type": "takeOff", "altitude": 8.0})
    wait_for("it hovers", lambda: api.drone(id)["flight"] == "inAir", 60)
    flown.states.append(state(api, id))
    flown.said["refusal"] = face.command(id, {"type": "takeOff", "altitude": 8.0})
    bad = {"type": "goTo", "latitude": 91.0, "longitude": 8.5, "altitude": 10.0}
    flown.said["bad input"] = face.command(id, bad)
    points = items(triangle(drone["home"]))
    flown.said["upload"] = face.command(id, {"type": "uploadMission", "items": points})
    flown.said["start"] = face.command(id, {"type": "startMission"})
    assert flown.said["start"] == SUCCEEDED, (flown.said["upload"], flown.said["start"])
    last = len(api.drone(id)["mission"]["items"]) - 1
    wait_for("the last waypoint is reached", lambda: last in api.drone(id)["mission"]["reached"], 120)
    flown.states.append(state(api, id))
    flown.said["return"] = face.command(id, {"type": "returnToLaunch"})
    wait_for("it landed and disarmed", lambda: state(api, id)[:2] == (False, "onGround"), 120)
    flown.states.append(state(api, id))
    assert api.call("DELETE", f"/grants/{grant}").status_code == 204
    flown.said["revoked"] = face.command(id, {"type": "takeOff", "altitude": 8.0})


def state(api: Api, id: str) -> tuple[Any, ...]:
    now = api.drone(id)
    return (now["armed"], now["flight"], now["mode"], now["mission"]["total"], now["control"]["state"])


def recorded(api: Api, drone: Json, user: str) -> list[Any]:
    """The user's records about this drone in their order, without what belongs to one flight alone."""
    records = api.get(f"/audit?drone={drone['id']}&user={user}&limit=200")["records"]
    return [
        (
            record["operation"],
            record["outcome"],
            *nameless((record["reason"], parameters(record["parameters"])), drone, user),
        )
        for record in sorted(records, key=lambda record: record["sequence"])
    ]


def parameters(text: str) -> str:
    """Without the id that each client makes for its commands, and without each drone's own places."""
    return re.sub(r"[-\d.]{4,}", "N", re.sub(r'"?\bid"?[=:] ?"?[\w-]{8,64}"?,? ?', "", text))


def nameless(said: tuple[Any, ...], drone: Json, user: str) -> tuple[Any, ...]:
    def plain(text: Any) -> Any:
        if not isinstance(text, str):
            return text
        return text.replace(drone["name"], "DRONE").replace(drone["id"], "ID").replace(user, "PILOT")

    return tuple(plain(part) for part in said)


def test_flight_by_rest_goes_as_it_should(flights: dict[str, Flown]) -> None:
    """End to end because a client of each face's own flies a copter of its own."""
    rest = flights["REST"]
    assert rest.seen == ["this drone"]
    assert rest.control == [("held", True, False), ("free", False, True)]
    for step in ("arm", "take off", "upload", "start", "return"):
        assert rest.said[step] == SUCCEEDED, step
    assert rest.said["refusal"][:3] == ("refused", "gate", "drone-airborne")
    assert rest.said["bad input"][4] == "latitude"
    assert rest.said["revoked"][2]
    assert [armed for armed, *_ in rest.states] == [True, True, False]
    assert len(rest.recorded) >= 9


@pytest.mark.parametrize("name", [name for name in FACES if name != "REST"])
def test_another_face_says_does_and_records_the_same(flights: dict[str, Flown], name: str) -> None:
    """End to end because a client of each face's own flies a copter of its own."""
    rest, other = flights["REST"], flights[name]
    assert other.seen == rest.seen
    assert other.control == rest.control
    for step, said in other.said.items():
        # dronectl names no field of its own.
        assert said == rest.said[step][: len(said)], step
    assert other.states == rest.states
    assert other.recorded == rest.recorded
