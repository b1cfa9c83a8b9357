"""Many people at once, each followed by a drone, who walk, run and ride across fences, over a bad network."""

import heapq
import json
import math
import random
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from .api import Api, Json
from .big_trial import boot_seconds, fix, to_degrees, to_metres
from .impairer import UNIMPAIRED, Impairer, LinkConditions
from .message_recorder import MessageRecorder
from .runs import ready_drone
from .server import Server
from .simulator import Simulator
from .trajectories import Disc
from .waiting import rounds, wait_for

FIRST_SYSTEM_ID = 1
DELAYED = LinkConditions(delay=0.3, jitter=0.2, loss=0.1)
# The simulator's vehicles stand so far from each other, in rows.
SPACING_METRES = 60.0
EDGE_METRES = 45.0
DISCS = 4
BESIDE_HOMES_METRES = 22.0
GOES_METRES = 40.0
SPEEDS = (1.4, 4.0, 8.0)
HEIGHTS = (5, 5, 6, 8, 12, 20)
LOWEST_METRES = 5.0
WANDERS_METRES, WANDERS_SECONDS, WHITE_METRES = 3.0, 60.0, 0.5
STEP_SECONDS = 0.1
SEPARATION = {"metres": 10.0, "height": 5.0}


@dataclass
class Field:
    """The area that is flown in, in metres east and north of the first home."""

    homes: list[tuple[float, float]]
    west: float
    south: float
    east: float
    north: float
    discs: list[Disc] = field(default_factory=list)

    @staticmethod
    def around(drones: list[Json], origin: Json, chance: random.Random) -> "Field":
        homes = [_to_metres(origin, drone["home"]) for drone in drones]
        easts, norths = [h[0] for h in homes], [h[1] for h in homes]
        made = Field(
            homes,
            min(easts) - EDGE_METRES,
            min(norths) - EDGE_METRES,
            max(easts) + EDGE_METRES,
            max(norths) + EDGE_METRES,
        )
        while len(made.discs) < DISCS:
            disc = Disc(
                f"Pond {len(made.discs) + 1}",
                chance.uniform(made.west, made.east),
                chance.uniform(made.south, made.north),
                chance.uniform(8, 14),
                math.inf,
            )
            if all(
                math.hypot(h[0] - disc.east, h[1] - disc.north) > disc.radius + BESIDE_HOMES_METRES
                for h in homes
            ):
                made.discs.append(disc)
        return made

    def zones(self, origin: Json) -> list[Json]:
        """Zones as bodies of REST requests."""

        def at(east: float, north: float) -> list[float]:
            there = to_degrees(origin, east, north)
            return [there["longitude"], there["latitude"]]

        corners = [
            (self.west, self.south),
            (self.east, self.south),
            (self.east, self.north),
            (self.west, self.north),
        ]
        ring = [at(*corner) for corner in [*corners, corners[0]]]
        stay_in = {
            "type": "Feature",
            "geometry": {"type": "Polygon", "coordinates": [ring]},
            "properties": {"name": "Field", "kind": "inclusion"},
        }
        keep_out = [
            {
                "type": "Feature",
                "geometry": {"type": "Point", "coordinates": at(disc.east, disc.north)},
                "properties": {"name": disc.name, "kind": "exclusion", "radius": disc.radius},
            }
            for disc in self.discs
        ]
        return [stay_in, *keep_out]


class SimulatedPhone:
    """A phone that goes from place to place, often where no drone may come, and sends its position."""

    def __init__(self, ground: Field, number: int, chance: random.Random) -> None:
        self._field = ground
        self._random = chance
        home = ground.homes[number]
        self._east, self._north = home[0] + chance.uniform(-8, 8), home[1] + chance.uniform(-8, 8)
        self._goal = (self._east, self._north)
        self._speed = chance.choice(SPEEDS)
        self._off = [chance.gauss(0, WANDERS_METRES) for _ in range(2)]
        self._due: list[tuple[float, int, Json]] = []
        self._position_count = 0
        self.walks = False
        self.follow = ""

    def position(self) -> tuple[float, float]:
        return self._east, self._north

    def move(self, seconds: float) -> None:
        if not self.walks:
            return
        east, north = self._goal[0] - self._east, self._goal[1] - self._north
        away = math.hypot(east, north)
        step = self._speed * seconds
        if away <= step:
            self._goal = self._next()
        else:
            self._east += east / away * step
            self._north += north / away * step

    def _next(self) -> tuple[float, float]:
        """In a disc, beyond the edge, or anywhere."""
        kind = self._random.random()
        if kind < 0.4:
            disc = self._random.choice(self._field.discs)
            return disc.east, disc.north
        beyond = GOES_METRES if kind < 0.7 else 0.0
        return (
            self._random.uniform(self._field.west - beyond, self._field.east + beyond),
            self._random.uniform(self._field.south - beyond, self._field.north + beyond),
        )

    def send_position(self, origin: Json, now: float, conditions: LinkConditions) -> None:
        """On its way from now on; what is lost is lost."""
        keep = math.exp(-1 / WANDERS_SECONDS)
        fresh = WANDERS_METRES * math.sqrt(1 - keep * keep)
        self._off = [off * keep + self._random.gauss(0, fresh) for off in self._off]
        east, north = (
            true + off + self._random.gauss(0, WHITE_METRES)
            for true, off in zip(self.position(), self._off, strict=True)
        )
        at = datetime.fromtimestamp(time.time(), UTC).isoformat()
        self._position_count += 1
        position = {"id": self._position_count, "at": at, "accuracy": 5} | to_degrees(origin, east, north)
        if self._random.random() >= conditions.loss:
            delay = conditions.delay + self._random.uniform(-conditions.jitter, conditions.jitter)
            heapq.heappush(
                self._due, (now + delay, self._position_count, {"sent": at, "positions": [position]})
            )

    def arrived(self, now: float) -> list[Json]:
        found = []
        while self._due and self._due[0][0] <= now:
            found.append(heapq.heappop(self._due)[2])
        return found


class FollowTrial:
    """One round: a server, a fleet in the wind, and as many phones."""

    def __init__(self, folder: Path, seed: int, follows: int, wind: float) -> None:
        self.random = random.Random(seed)
        self.follows = follows
        self.folder = folder
        self.server = Server(folder / "data")
        self.server.start()
        self.link = Impairer(self.server.udp_port, seed)
        self.recorder = MessageRecorder(self.link.port, ("GLOBAL_POSITION_INT",))
        self.simulator = Simulator(
            folder / "sim.log",
            f"udp://127.0.0.1:{self.recorder.port}",
            *("--count", str(follows), "--sysid", str(FIRST_SYSTEM_ID), "--seed", str(seed)),
            *("--wind", f"{wind:g}"),
        )
        self.api = Api(self.server.address, self.server.local_key())

    def close(self) -> None:
        self.simulator.stop()
        self.recorder.close()
        self.link.close()
        self.server.stop()

    def fly(self, seconds: float) -> Json:
        """Flies one round; returns what the judge found from the vehicles' positions alone."""
        drones = [
            wait_for("all is known", partial(ready_drone, self.api, FIRST_SYSTEM_ID + n), 180)
            for n in range(self.follows)
        ]
        origin: Json = drones[0]["home"]
        ground = Field.around(drones, origin, self.random)
        for zone in ground.zones(origin):
            answer = self.api.call("POST", "/zones", zone)
            assert answer.status_code == 201, answer.text
        phones = [SimulatedPhone(ground, number, self.random) for number in range(self.follows)]
        for phone, drone in zip(phones, drones, strict=True):
            self._request_follow(phone, drone, origin)
        self.link.conditions = DELAYED
        self._send_positions(phones, origin, 180, lambda: self._all_in_state(phones, "tracking"))
        begun = time.monotonic()
        for phone in phones:
            phone.walks = True
        self._send_positions(phones, origin, seconds)
        ended = time.monotonic()
        states = [self.api.get(f"/follows/{phone.follow}") for phone in phones]
        self.link.conditions = UNIMPAIRED
        return self._judgement(origin, ground, (begun, ended)) | {
            "states": [one["state"] for one in states],
            "why": [one["told"][-1]["words"] for one in states if one["state"] != "tracking"],
        }

    def _request_follow(self, phone: SimulatedPhone, drone: Json, origin: Json) -> None:
        sides: list[Json] = [
            {"side": "behind"},
            {"side": "ahead"},
            {"side": "fixed", "bearing": self.random.randrange(360)},
        ]
        beside: Json = {"distance": self.random.randrange(3, 16), "height": self.random.choice(HEIGHTS)}
        order = to_degrees(origin, *phone.position()) | {
            "drone": drone["id"],
            "place": self.random.choice(sides) | beside,
        }
        answer = self.api.call("POST", "/follows", order)
        assert answer.status_code == 201, answer.text
        phone.follow = answer.json()["id"]
        assert self.api.call("POST", f"/follows/{phone.follow}/start").ok

    def _all_in_state(self, phones: list[SimulatedPhone], state: str) -> bool:
        seen = {one["id"]: one["state"] for one in self.api.get("/follows")["follows"]}
        return all(seen[phone.follow] == state for phone in phones)

    def _send_positions(
        self,
        phones: list[SimulatedPhone],
        origin: Json,
        seconds: float,
        until: Callable[[], bool] | None = None,
    ) -> None:
        """Moves the phones and sends their positions, for so long or until that is so."""
        last_sent = [time.monotonic() - self.random.random() for _ in phones]
        looked = 0.0
        for _ in rounds(time.monotonic() + seconds, STEP_SECONDS):
            for number, phone in enumerate(phones):
                now = time.monotonic()
                phone.move(STEP_SECONDS)
                if now - last_sent[number] >= 1:
                    last_sent[number] += 1
                    phone.send_position(origin, now, DELAYED)
                for message in phone.arrived(now):
                    answer = self.api.call("POST", f"/follows/{phone.follow}/positions", message)
                    assert answer.ok, answer.text
            if until is not None and time.monotonic() - looked > 1:
                looked = time.monotonic()
                if until():
                    return
        assert until is None, f"not all follow after {seconds:.0f} s: {self.api.get('/follows')}"

    def _judgement(self, origin: Json, ground: Field, when: tuple[float, float]) -> Json:
        tracks: dict[int, list[list[float]]] = {}
        for one in self.recorder.messages("GLOBAL_POSITION_INT", up=True):
            if when[0] <= one.at <= when[1]:
                here = fix(origin, one)
                row = [boot_seconds(one), here.east, here.north, here.up, here.above_home]
                tracks.setdefault(one.message.get_srcSystem(), []).append(row)
        truth = {
            "inside": [ground.west, ground.south, ground.east, ground.north],
            "discs": [[disc.east, disc.north, disc.radius] for disc in ground.discs],
            "lowest": LOWEST_METRES,
            "separation": SEPARATION,
            "tracks": tracks,
        }
        file = self.folder / "truth.json"
        file.write_text(json.dumps(truth))
        judge = [sys.executable, "-m", "dronemap_e2e.follow_judge", str(file)]
        root = Path(__file__).resolve().parents[1]
        found: Json = json.loads(subprocess.run(judge, capture_output=True, check=True, cwd=root).stdout)
        return found


def _to_metres(origin: Json, there: Json) -> tuple[float, float]:
    return to_metres(origin, there["latitude"], there["longitude"])
