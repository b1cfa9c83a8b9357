"""Ten people at once, each followed by a drone whose battery runs low while another ten wait."""

import json
import math
import random
import subprocess
import sys
import time
from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from .api import Api, Json
from .big_trial import fix, to_degrees, to_metres
from .follow_trial import FIRST_SYSTEM_ID, SEPARATION, STEP_SECONDS, Field, SimulatedPhone
from .impairer import UNIMPAIRED
from .message_recorder import MessageRecorder
from .runs import ready_drone
from .server import Server
from .simulator import Simulator
from .waiting import rounds, wait_for

WANDERS_WITHIN_METRES = 35.0
SPEEDS = (1.4, 1.4, 3.0)
# What is left in the fullest battery that is to be replaced, and how much less there is in each next one.
FULLEST_PERCENT, APART_PERCENT = 46, 1.5
LOOK_SECONDS = 1.0
# From who is followed to the nearest of the drones of that follow, on the ground: up to 12 m are asked for,
# and ten cross each other's ways.
KEPT_METRES = 50
# Each drone is heard in each of these, also on a busy machine.
MOMENT_SECONDS = 2.0


class WanderingPhone(SimulatedPhone):
    """Goes about near where it began, across the ways of others."""

    def __init__(self, ground: Field, number: int, chance: random.Random) -> None:
        super().__init__(ground, number, chance)
        self._origin = self.position()
        self._speed = chance.choice(SPEEDS)
        self.path: list[tuple[float, float, float]] = []

    def _next(self) -> tuple[float, float]:
        reach = WANDERS_WITHIN_METRES
        return (
            self._origin[0] + self._random.uniform(-reach, reach),
            self._origin[1] + self._random.uniform(-reach, reach),
        )

    def move(self, seconds: float) -> None:
        super().move(seconds)
        self.path.append((time.monotonic(), *self.position()))

    def position_at(self, at: float) -> tuple[float, float]:
        index = min(bisect_left(self.path, (at,)), len(self.path) - 1)
        return self.path[index][1:]


@dataclass
class FollowHistory:
    """States, drones and messages that the follow of one phone went through."""

    states: set[str] = field(default_factory=set)
    drones: list[str] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)

    def update(self, follow: Json) -> None:
        self.states.add(follow["state"])
        self.messages = [one["words"] for one in follow["told"]]
        if follow["drone"] not in self.drones:
            self.drones.append(follow["drone"])


class ReliefTrial:
    """A server, twice as many drones as phones, and what became of them."""

    def __init__(self, folder: Path, seed: int, phones: int) -> None:
        self.random = random.Random(seed)
        self.count = phones
        self.folder = folder
        self.server = Server(folder / "data")
        self.server.start()
        self.recorder = MessageRecorder(self.server.udp_port, ("GLOBAL_POSITION_INT",))
        self.simulator = Simulator(
            folder / "sim.log",
            f"udp://127.0.0.1:{self.recorder.port}",
            *("--count", str(2 * phones), "--sysid", str(FIRST_SYSTEM_ID), "--seed", str(seed)),
        )
        self.api = Api(self.server.address, self.server.local_key())
        self.phones: list[WanderingPhone] = []
        self.seen: list[FollowHistory] = []

    def close(self) -> None:
        self.simulator.stop()
        self.recorder.close()
        self.server.stop()

    def fly(self, longest: float, after: float) -> Json:
        """Flies until each drone was replaced, and a little longer; returns what was measured."""
        drones = [
            wait_for("all is known", partial(ready_drone, self.api, FIRST_SYSTEM_ID + n), 180)
            for n in range(2 * self.count)
        ]
        origin: Json = drones[0]["home"]
        homes = [
            to_metres(origin, drone["home"]["latitude"], drone["home"]["longitude"])
            for drone in drones[: self.count]
        ]
        ground = Field(homes, 0, 0, 0, 0)
        self.phones = [WanderingPhone(ground, number, self.random) for number in range(self.count)]
        self.seen = [FollowHistory() for _ in self.phones]
        for phone, drone in zip(self.phones, drones[: self.count], strict=True):
            self._request_follow(phone, drone, origin)
        self._send_positions(origin, 120, lambda: all("tracking" in seen.states for seen in self.seen))
        for seen in self.seen:
            seen.states.clear()
        for drone in drones[self.count :]:
            assert self.api.call("PUT", f"/warehouse/{drone['id']}", {}).ok
        for number, phone in enumerate(self.phones):
            phone.walks = True
            percent = FULLEST_PERCENT - APART_PERCENT * number
            self.simulator.fault(f"{FIRST_SYSTEM_ID + number} battery {percent:g}")
        began = time.monotonic()
        self._send_positions(origin, longest, lambda: all(len(seen.drones) > 1 for seen in self.seen))
        replaced = time.monotonic() - began
        self._send_positions(origin, after)
        numbers = {drone["id"]: FIRST_SYSTEM_ID + number for number, drone in enumerate(drones)}
        return {"replaced": replaced} | self._judgement(origin, numbers, (began, time.monotonic()))

    def _request_follow(self, phone: WanderingPhone, drone: Json, origin: Json) -> None:
        beside: Json = {"distance": self.random.randrange(5, 13), "height": self.random.randrange(10, 21)}
        order = to_degrees(origin, *phone.position()) | {
            "drone": drone["id"],
            "place": {"side": self.random.choice(("behind", "ahead"))} | beside,
        }
        answer = self.api.call("POST", "/follows", order)
        assert answer.status_code == 201, answer.text
        phone.follow = answer.json()["id"]
        assert self.api.call("POST", f"/follows/{phone.follow}/start").ok

    def _send_positions(self, origin: Json, seconds: float, until: Callable[[], bool] | None = None) -> None:
        last_sent = [time.monotonic() - self.random.random() for _ in self.phones]
        looked = 0.0
        moved = time.monotonic()
        for _ in rounds(time.monotonic() + seconds, STEP_SECONDS):
            now = time.monotonic()
            for number, phone in enumerate(self.phones):
                phone.move(now - moved)
                if now - last_sent[number] >= 1:
                    last_sent[number] += 1
                    phone.send_position(origin, now, UNIMPAIRED)
                for message in phone.arrived(now):
                    answer = self.api.call("POST", f"/follows/{phone.follow}/positions", message)
                    assert answer.ok, answer.text
            moved = now
            if now - looked > LOOK_SECONDS:
                looked = now
                found = {one["id"]: one for one in self.api.get("/follows")["follows"]}
                for phone, seen in zip(self.phones, self.seen, strict=True):
                    seen.update(found[phone.follow])
                if until is not None and until():
                    return
        assert until is None, f"not within {seconds:.0f} s: {self.seen}"

    def _judgement(self, origin: Json, numbers: dict[str, int], when: tuple[float, float]) -> Json:
        tracks: dict[int, list[list[float]]] = {}
        for one in self.recorder.messages("GLOBAL_POSITION_INT", up=True):
            if when[0] <= one.at <= when[1]:
                here = fix(origin, one)
                row = [one.at, here.east, here.north, here.up, here.above_home]
                tracks.setdefault(one.message.get_srcSystem(), []).append(row)
        truth = {
            "inside": [-1e5, -1e5, 1e5, 1e5],
            "discs": [],
            "lowest": -1,
            "separation": SEPARATION,
            "tracks": tracks,
            "walked": [phone.path for phone in self.phones],
        }
        file = self.folder / "truth.json"
        file.write_text(json.dumps(truth))
        judge = [sys.executable, "-m", "dronemap_e2e.follow_judge", str(file)]
        root = Path(__file__).resolve().parents[1]
        found: Json = json.loads(subprocess.run(judge, capture_output=True, check=True, cwd=root).stdout)
        away = [
            self._distances(phone, [tracks[numbers[drone]] for drone in seen.drones], when)
            for phone, seen in zip(self.phones, self.seen, strict=True)
        ]
        return {
            "apart": found["apart"],
            "vehicles": found["vehicles"],
            "farthest": [max(metres) for metres in away],
            "longest": [MOMENT_SECONDS * longest(metres, KEPT_METRES) for metres in away],
        }

    @staticmethod
    def _distances(
        phone: WanderingPhone, tracks: list[list[list[float]]], when: tuple[float, float]
    ) -> list[float]:
        """Metres from a phone to the nearest of its drones in the air, each moment; infinite: none flew."""
        nearest: dict[int, float] = {}
        for track in tracks:
            for at, east, north, _, above_home in track:
                if above_home > 3:
                    there = phone.position_at(at)
                    metres = math.hypot(east - there[0], north - there[1])
                    moment = int(at / MOMENT_SECONDS)
                    nearest[moment] = min(nearest.get(moment, math.inf), metres)
        moments = range(int(when[0] / MOMENT_SECONDS) + 1, int(when[1] / MOMENT_SECONDS))
        return [nearest.get(moment, math.inf) for moment in moments]


def longest(metres: list[float], kept: float) -> int:
    """The longest row of moments that were farther than that."""
    most = row = 0
    for one in metres:
        row = row + 1 if one > kept else 0
        most = max(most, row)
    return most
