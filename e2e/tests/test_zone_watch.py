"""The watch over zones in flight, in wind and for many drones at once, judged on the wire: a long run."""

import math
import random
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import NamedTuple, TypeVar

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.message_recorder import MessageRecorder
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

METERS_PER_DEGREE = 111_195.0
DRONES, ROUNDS = 20, 10
FIRST_SYSTEM_ID = 100
RADIUS, AHEAD = 25.0, 120.0
WITHIN_SECONDS = 1.0


Given = TypeVar("Given")
Made = TypeVar("Made")


def in_parallel(do: Callable[[Given], Made], things: Sequence[Given]) -> list[Made]:
    """One after the other, twenty drones would take twenty times as long."""
    with ThreadPoolExecutor(len(things)) as pool:
        return list(pool.map(do, things))


class Place(NamedTuple):
    latitude: float
    longitude: float

    def shifted(self, meters: float, bearing: float) -> "Place":
        narrow = math.cos(math.radians(self.latitude))
        return Place(
            self.latitude + meters * math.cos(bearing) / METERS_PER_DEGREE,
            self.longitude + meters * math.sin(bearing) / METERS_PER_DEGREE / narrow,
        )

    def meters_to(self, other: "Place") -> float:
        narrow = math.cos(math.radians(self.latitude))
        north = (other.latitude - self.latitude) * METERS_PER_DEGREE
        east = (other.longitude - self.longitude) * METERS_PER_DEGREE * narrow
        return math.hypot(north, east)


class Breach(NamedTuple):
    """One zone put in the way of one drone that flies."""

    drone: Json
    zone: str
    middle: Place
    put: float


def where(api: Api, drone: Json) -> Place:
    position = api.drone(drone["id"])["position"]
    return Place(position["latitude"], position["longitude"])


def send_away(api: Api, drone: Json, bearing: float) -> Breach:
    """Lets it fly there, and puts a zone in its way once it does."""
    start = where(api, drone)
    target = start.shifted(500, bearing)
    body = {"type": "goTo", "latitude": target.latitude, "longitude": target.longitude, "altitude": 10}
    api.do(drone["id"], **body)
    wait_for("it flies there", lambda: where(api, drone).meters_to(start) > 5, 60)
    middle = start.shifted(AHEAD, bearing)
    zone = {
        "type": "Feature",
        "geometry": {"type": "Point", "coordinates": [middle.longitude, middle.latitude]},
        "properties": {"name": "Sudden", "drone": drone["id"], "radius": RADIUS, "onBreach": "hold"},
    }
    answer = api.call("POST", "/zones", zone)
    assert answer.status_code == 201, answer.text
    return Breach(drone, answer.json()["id"], middle, time.monotonic())


def action_delay(recorder: MessageRecorder, breach: Breach) -> tuple[float, float]:
    """When it first reported to be inside (monotonic s), and seconds until it was ordered to hold."""
    system_id = breach.drone["link"]["systemId"]
    inside = next(
        h.at
        for h in recorder.messages("GLOBAL_POSITION_INT", up=True, since=breach.put)
        if h.message.get_srcSystem() == system_id
        and Place(h.message.lat / 1e7, h.message.lon / 1e7).meters_to(breach.middle) < RADIUS
    )
    ordered = next(
        h.at
        for h in recorder.messages("COMMAND_LONG", "SET_MODE", up=False, since=breach.put)
        if h.message.target_system == system_id and (h.kind == "SET_MODE" or h.message.command == 176)
    )
    return inside, ordered - inside


def warning_time(api: Api, drone: Json, words: str, since: float) -> float | None:
    """When a message with these words was first shown since then (monotonic s)."""
    offset = time.time() - time.monotonic()
    times = [
        datetime.fromisoformat(m["at"].replace("Z", "+00:00")).timestamp() - offset
        for m in api.drone(drone["id"])["messages"]
        if words in m["text"]
    ]
    return next((at for at in sorted(times) if at >= since - 0.1), None)


def take_off(api: Api, drone: Json) -> None:
    api.do(drone["id"], type="setMode", mode="GUIDED")
    api.do(drone["id"], type="arm")
    api.do(drone["id"], type="takeOff", altitude=10)


@pytest.fixture
def fleet(server: Server, api: Api, recorder: MessageRecorder, tmp_path: Path) -> Iterator[list[Json]]:
    options = ["--count", str(DRONES), "--sysid", str(FIRST_SYSTEM_ID), "--speedup", "2", "--wind", "6"]
    simulator = Simulator(tmp_path / "sim.log", f"udp://127.0.0.1:{recorder.port}", *options)
    ids = range(FIRST_SYSTEM_ID, FIRST_SYSTEM_ID + DRONES)
    drones = [wait_for("it is ready", partial(api.ready, one), 120) for one in ids]
    in_parallel(partial(take_off, api), drones)
    yield drones
    simulator.stop()


@pytest.mark.soak
def test_two_hundred_zone_breaches_are_warned_of_and_acted_on_within_a_second(
    api: Api, recorder: MessageRecorder, fleet: list[Json]
) -> None:
    chance = random.Random(7)
    delays, ahead = [], []
    for _ in range(ROUNDS):
        ways = [(drone, chance.random() * 2 * math.pi) for drone in fleet]
        breaches = in_parallel(lambda way: send_away(api, *way), ways)
        for breach in breaches:
            wait_for(
                "it is told to hold",
                partial(warning_time, api, breach.drone, "is told: hold", breach.put),
                120,
            )
        for breach in breaches:
            inside, delay = action_delay(recorder, breach)
            warned = warning_time(api, breach.drone, "If it goes on like this it enters", breach.put)
            assert warned is not None and warned < inside, f"no warning before {breach}"
            delays.append(delay)
            ahead.append(inside - warned)
            assert api.call("DELETE", f"/zones/{breach.zone}").status_code == 204
    late = [delay for delay in delays if delay > WITHIN_SECONDS]
    print(f"{len(delays)} breaches, acted on after {sorted(delays)[len(delays) // 2]:.3f} s (median),")
    print(f"{max(delays):.3f} s (latest); warned of {min(ahead):.1f} s (latest) before")
    assert len(delays) == DRONES * ROUNDS and not late, late
