"""Six drones, 120 waypoints and all that may go wrong, by a seed, over real sockets."""

import json
import math
import random
import time
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .api import Api, Json
from .flight import EARTH_RADIUS_METERS
from .impairer import UNIMPAIRED, Impairer, LinkConditions
from .message_recorder import MessageRecorder, RecordedMessage
from .runs import create_plan, ready_drone, stages
from .server import Server
from .simulator import Simulator
from .trajectories import Disc, Fix, Spot, Track
from .waiting import rounds, wait_for

DRONES = 6
WAYPOINTS = 120
ADDED = 10
FIRST_SYSTEM_ID = 1
FIELD_METRES = 380.0
FIRST_NORTH_METRES = 40.0
APART_METRES = 9.0
BESIDE_DISCS_METRES = 16.0
HEIGHTS = (22.0, 28.0, 34.0)
SEARCH_SECONDS = 1
GUST_SPEED = 3
LEAST_LEFT = 3
UP_METRES = 15.0
LONGEST_SECONDS = 1800.0
PER_DEGREE = math.radians(1) * EARTH_RADIUS_METERS
KINDS = (
    "GLOBAL_POSITION_INT",
    "MISSION_COUNT",
    "MISSION_ITEM_INT",
    "MISSION_ACK",
)


@dataclass(frozen=True)
class Fault:
    """Something that was done to one drone: `at` monotonic seconds, `moment` those of the calendar."""

    kind: str
    system_id: int
    drone: str
    at: float
    moment: float


@dataclass
class Trial:
    """One trial: the faults that were made, and what the server explained."""

    seed: int
    on_cloud_loss: str
    origin: Json
    spots: list[Spot]
    discs: list[Disc]
    faults: list[Fault] = field(default_factory=list)
    dead: tuple[float, float] = (math.inf, math.inf)
    """From when to when no server was there, monotonic seconds."""
    added_at: float = math.inf
    explanations: dict[str, Json] = field(default_factory=dict)
    """All that was told, also what the run's picture does not hold any more."""
    over: Json = field(default_factory=dict)
    replay: Json = field(default_factory=dict)

    def of(self, kind: str) -> Fault:
        return next(fault for fault in self.faults if fault.kind == kind)


def to_metres(origin: Json, latitude: float, longitude: float) -> tuple[float, float]:
    """Metres east and north."""
    across = PER_DEGREE * math.cos(math.radians(origin["latitude"]))
    return (longitude - origin["longitude"]) * across, (latitude - origin["latitude"]) * PER_DEGREE


def to_degrees(origin: Json, east: float, north: float) -> Json:
    across = PER_DEGREE * math.cos(math.radians(origin["latitude"]))
    return {
        "latitude": origin["latitude"] + north / PER_DEGREE,
        "longitude": origin["longitude"] + east / across,
    }


class BigTrialRunner:
    """Has one trial flown."""

    def __init__(
        self, folder: Path, seed: int, conditions: LinkConditions = UNIMPAIRED, speedup: float = 1
    ) -> None:
        self.random = random.Random(seed)
        self.seed = seed
        self.folder = folder
        self.server = Server(folder / "data")
        self.server.start()
        self.link = Impairer(self.server.udp_port, seed)
        self.conditions = conditions
        self.recorder = MessageRecorder(self.link.port, KINDS)
        self.simulator = Simulator(
            folder / "sim.log",
            f"udp://127.0.0.1:{self.recorder.port}",
            *("--count", str(DRONES), "--sysid", str(FIRST_SYSTEM_ID), "--seed", str(seed)),
            *("--speedup", f"{speedup:g}", "--wind", str(GUST_SPEED)),
        )
        self.api = Api(self.server.address, self.server.local_key())
        self.run = ""

    def close(self) -> None:
        self.simulator.stop()
        self.recorder.close()
        self.link.close()
        self.server.stop()

    def fly(self) -> Trial:
        drones = [
            wait_for("all is known", partial(ready_drone, self.api, FIRST_SYSTEM_ID + n), 120)
            for n in range(DRONES)
        ]
        self.ids = {drone["id"]: FIRST_SYSTEM_ID + n for n, drone in enumerate(drones)}
        origin = drones[0]["home"]
        trial = Trial(self.seed, self.random.choice(["rtl", "continue"]), origin, [], self._fences(origin))
        asked = [self._waypoint(trial) for _ in range(WAYPOINTS)]
        self._start(create_plan(self.api, drones, asked), trial)
        self.link.conditions = self.conditions
        deeds = ["motor", "link", "battery", "waypoints", "restart"]
        self.random.shuffle(deeds)
        for deed in deeds:
            self._wait(trial, self.random.uniform(8, 35))
            if deed == "waypoints":
                self._add_waypoints(trial)
            elif deed == "restart":
                self._restart_server(trial)
            else:
                self._inject_fault(trial, deed)
        trial.over = wait_for("the run is over", partial(self._run_if_over, trial), LONGEST_SECONDS, every=1)
        trial.replay = self.api.get(f"{self.run}/journal/replay")
        whole = trial.over | {"explanations": list(trial.explanations.values())}
        (self.folder / "run.json").write_text(json.dumps(whole, indent=1))
        return trial

    def _run_if_over(self, trial: Trial) -> Json | None:
        now = self._poll(trial)
        return now if now["state"] == "over" else None

    def _fences(self, origin: Json) -> list[Disc]:
        """Two buildings in the field, which drones on their way home by themselves pass over, and a
        no-fly zone at its far end, behind which nobody has to be."""
        discs = [
            Disc("Mill", 120, 170, 18, 36),
            Disc("Silo", 250, 260, 15, 36),
            Disc("Mast", 330, 400, 20, math.inf),
        ]
        for disc in discs:
            centre = to_degrees(origin, disc.east, disc.north)
            bound = {} if math.isinf(disc.top) else {"ceiling": origin["altitudeAmsl"] + disc.top}
            answer = self.api.call(
                "POST",
                "/zones",
                {
                    "type": "Feature",
                    "geometry": {"type": "Point", "coordinates": [centre["longitude"], centre["latitude"]]},
                    "properties": {"name": disc.name, "kind": "exclusion", "radius": disc.radius}
                    | {"altitudeReference": "amsl"}
                    | bound,
                },
            )
            assert answer.status_code == 201, answer.text
        return discs

    def _waypoint(self, trial: Trial) -> Json:
        """Somewhere in the field, apart from all others and from what is fenced."""
        while True:
            east = self.random.uniform(-30, FIELD_METRES - 30)
            north = self.random.uniform(FIRST_NORTH_METRES, FIRST_NORTH_METRES + FIELD_METRES)
            clear = all(
                math.hypot(east - s.east, north - s.north) > APART_METRES for s in trial.spots
            ) and all(
                math.hypot(east - d.east, north - d.north) > d.radius + BESIDE_DISCS_METRES
                for d in trial.discs
            )
            if clear:
                break
        height = self.random.choice(HEIGHTS)
        trial.spots.append(Spot(str(len(trial.spots) + 1), east, north, height))
        return to_degrees(trial.origin, east, north) | {
            "altitude": trial.origin["altitudeAmsl"] + height,
            "altitudeReference": "amsl",
        }

    def _start(self, plan: str, trial: Trial) -> None:
        asked = {"plan": plan, "onCloudLoss": trial.on_cloud_loss, "searchSeconds": SEARCH_SECONDS}
        started = self.api.call("POST", "/runs", asked)
        assert started.status_code == 201, started.text
        self.run = f"/runs/{started.json()['id']}"
        flying = {"flying"}
        wait_for("all fly", lambda: set(stages(self.api.get(self.run)).values()) == flying, 180, every=0.5)

    def _wait(self, trial: Trial, seconds: float) -> None:
        for _ in rounds(time.monotonic() + seconds, 0.5):
            self._poll(trial)

    def _poll(self, trial: Trial) -> Json:
        now = self.api.get(self.run)
        trial.explanations.update({one["at"] + one["words"]: one for one in now["explanations"]})
        return now

    def _add_waypoints(self, trial: Trial) -> None:
        body = {"waypoints": [self._waypoint(trial) for _ in range(ADDED)]}
        trial.added_at = time.monotonic()
        answer = self.api.call("POST", f"{self.run}/waypoints", body)
        assert answer.ok, answer.text
        known_by = [one["id"] for one in answer.json()["waypoints"]][-ADDED:]
        for number, name in enumerate(known_by):
            spot = trial.spots[len(trial.spots) - ADDED + number]
            trial.spots[len(trial.spots) - ADDED + number] = Spot(name, spot.east, spot.north, spot.up)

    def _restart_server(self, trial: Trial) -> None:
        dead = time.monotonic()
        self.server.kill()
        self.server.start()
        trial.dead = (dead, time.monotonic())
        self.api = Api(self.server.address, self.server.local_key())

    def _inject_fault(self, trial: Trial, kind: str) -> None:
        """One that flies, with something left to do, and was not harmed yet."""
        harmed = {fault.drone for fault in trial.faults}

        def fit() -> list[str]:
            return [
                drone["id"]
                for drone in self._poll(trial)["drones"]
                if drone["stage"] == "flying"
                and drone["id"] not in harmed
                and len(drone["next"]) >= LEAST_LEFT
                and self._height(drone["id"]) > UP_METRES
            ]

        drone = self.random.choice(wait_for("somebody flies on", fit, 240, every=0.5))
        system_id = self.ids[drone]
        at, moment = time.monotonic(), time.time()
        if kind == "link":
            self.recorder.cut.add(system_id)
        elif kind == "motor":
            self.simulator.fault(f"{system_id} motor-failure")
        else:
            self.simulator.fault(f"{system_id} battery {self.random.choice([15, 18, 24])}")
        trial.faults.append(Fault(kind, system_id, drone, at, moment))

    def _height(self, drone: str) -> float:
        above: float = self.api.drone(drone)["position"]["altitudeAboveHome"]
        return above

    def tracks(self, trial: Trial) -> dict[int, Track]:
        """Tracks by the vehicles' own reports, before anything was lost; who fell counts no longer."""
        recorded = self.recorder.messages("GLOBAL_POSITION_INT", up=True)
        fell = next((fault for fault in trial.faults if fault.kind == "motor"), None)
        tracks = {}
        for system_id in self.ids.values():
            own = [one for one in recorded if one.message.get_srcSystem() == system_id]
            ends = math.inf
            if fell is not None and fell.system_id == system_id:
                ends = max(boot_seconds(one) for one in own if one.at <= fell.at)
            tracks[system_id] = Track([fix(trial.origin, one) for one in own], ends)
        return tracks

    def boot_seconds(self, moment: float) -> float:
        """Time of the vehicles' common clock at a moment of ours."""
        recorded = self.recorder.messages("GLOBAL_POSITION_INT", up=True)
        return max((boot_seconds(one) for one in recorded if one.at <= moment), default=math.inf)

    def acknowledged_missions(self, trial: Trial) -> list[tuple[float, int, set[str]]]:
        """Each mission that a vehicle acknowledged: when, who, and which waypoints are in it."""
        missions: dict[int, dict[int, RecordedMessage]] = {}
        found = []
        for one in self.recorder.messages("MISSION_COUNT", "MISSION_ITEM_INT", "MISSION_ACK"):
            message = one.message
            if getattr(message, "mission_type", 0) != mavlink.MAV_MISSION_TYPE_MISSION:
                continue
            if not one.up and one.kind == "MISSION_COUNT":
                missions[message.target_system] = {}
            elif not one.up and one.kind == "MISSION_ITEM_INT":
                missions.setdefault(message.target_system, {})[message.seq] = one
            elif one.up and one.kind == "MISSION_ACK" and message.type == mavlink.MAV_MISSION_ACCEPTED:
                system_id = message.get_srcSystem()
                items = missions.get(system_id, {}).values()
                found.append((one.at, system_id, {s.name for s in trial.spots if _leads_to(trial, items, s)}))
        return found


def _leads_to(trial: Trial, items: object, spot: Spot) -> bool:
    assert hasattr(items, "__iter__")
    for one in items:
        item = one.message
        if item.x and item.y:
            east, north = to_metres(trial.origin, item.x / 1e7, item.y / 1e7)
            if math.hypot(east - spot.east, north - spot.north) < 1:
                return True
    return False


def boot_seconds(recorded: RecordedMessage) -> float:
    seconds: float = recorded.message.time_boot_ms / 1000
    return seconds


def fix(origin: Json, recorded: RecordedMessage) -> Fix:
    message = recorded.message
    east, north = to_metres(origin, message.lat / 1e7, message.lon / 1e7)
    up = message.alt / 1e3 - origin["altitudeAmsl"]
    return Fix(boot_seconds(recorded), east, north, up, message.relative_alt / 1e3)
