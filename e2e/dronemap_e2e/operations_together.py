"""Operations of several users whose ways cross at one height, over the faces of a server."""

import random
import time
from functools import partial
from typing import NamedTuple

from .api import Api, Json
from .flight import Point, items
from .ground_station import new_user
from .runs import create_plan, ready_drone
from .server import Server
from .true_tracks import Operation
from .waiting import wait_for

METRES_PER_DEGREE, SHRINKS = 111_195.0, 0.67694
HEIGHT_METRES, UNEVEN_METRES = 20.0, 0.7
# Waypoints lie in a square north of the pads.
NEAR_METRES, FAR_METRES = 35.0, 115.0
WIDE_METRES = 110.0
LEAST_APART_METRES = 18.0


class User(NamedTuple):
    """Somebody with an operation, and who commands its drones."""

    name: str
    api: Api


def supervisor(server: Server, local: Api) -> User:
    user = new_user(server, local, "supervisor")
    return User(user.name, user.api)


def scattered(home: Json, count: int, chance: random.Random) -> list[Point]:
    """Over one square, far enough from each other; metres above home."""
    found: list[tuple[float, float]] = []
    while len(found) < count:
        spot = chance.uniform(NEAR_METRES, FAR_METRES), chance.uniform(-WIDE_METRES / 2, WIDE_METRES / 2)
        if all(abs(spot[0] - n) + abs(spot[1] - e) > LEAST_APART_METRES for n, e in found):
            found.append(spot)
    return [
        Point(
            home["latitude"] + north / METRES_PER_DEGREE,
            home["longitude"] + east / (METRES_PER_DEGREE * SHRINKS),
            HEIGHT_METRES + chance.uniform(-UNEVEN_METRES, UNEVEN_METRES),
        )
        for north, east in found
    ]


def judged_waypoints(points: list[Point], home: Json) -> list[Json]:
    return [
        {
            "name": str(number),
            "latitude": point.latitude,
            "longitude": point.longitude,
            "amsl": home["altitudeAmsl"] + point.altitude,
        }
        for number, point in enumerate(points, 1)
    ]


def ready(api: Api, system_ids: list[int]) -> list[Json]:
    return [wait_for("all is known of it", partial(ready_drone, api, one), 120) for one in system_ids]


class RunOperation:
    """A mission run, planned and ready to begin."""

    def __init__(self, name: str, user: User, drones: list[Json], points: list[Point]) -> None:
        home = drones[0]["home"]
        self._api = user.api
        self._plan = create_plan(user.api, drones, [_waypoint(point) for point in points])
        planned = user.api.get(f"/plans/{self._plan}")["result"]
        assert not planned["unserved"], planned
        self.operation = Operation(
            name,
            [str(drone["link"]["systemId"]) for drone in drones],
            judged_waypoints(points, home),
            undisturbed=planned["endsSeconds"],
        )

    def begin(self) -> None:
        self.operation.begins = time.monotonic()
        answer = self._api.call("POST", "/runs", {"plan": self._plan})
        assert answer.status_code == 201, answer.text


class VirtualOperation:
    """A mission of a virtual drone for the only drone that its user may see."""

    def __init__(self, name: str, user: User, drone: Json, points: list[Point]) -> None:
        self._api = user.api
        body = {"name": name, "items": [{"type": "takeOff", "altitude": HEIGHT_METRES}, *items(points)]}
        answer = user.api.call("POST", "/virtual-drones", body)
        assert answer.status_code == 201, answer.text
        self._id = answer.json()["id"]
        self.operation = Operation(
            name, [str(drone["link"]["systemId"])], judged_waypoints(points, drone["home"])
        )

    def begin(self) -> None:
        self.operation.begins = time.monotonic()
        answer = self._api.call("POST", f"/virtual-drones/{self._id}/start")
        assert answer.status_code == 202, answer.text


def _waypoint(point: Point) -> Json:
    return {"latitude": point.latitude, "longitude": point.longitude, "altitude": point.altitude}
