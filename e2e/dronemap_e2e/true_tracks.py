"""Writes down where vehicles truly were every 0.1 s, in the form that the judge of separation reads."""

import json
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import TextIO

from .api import Json
from .separation_judge import COLUMNS, STEPS_PER_SECOND, Limits, Verdict, judge_folder
from .simulator import Simulator
from .sitl_drone import SitlDrone

# Above the sea, of all homes of the simulator.
GROUND_AMSL_METRES = 488.0
POLL_SECONDS = 0.05
# Nothing is judged that nobody has seen for longer.
LONGEST_GAP_SECONDS = 0.5


@dataclass(frozen=True)
class Fix:
    """Monotonic seconds, degrees, metres above the sea."""

    at: float
    latitude: float
    longitude: float
    amsl: float
    armed: bool


@dataclass
class Operation:
    """What somebody flies: its vehicles by name, and the waypoints that all have to be passed."""

    name: str
    vehicles: list[str]
    waypoints: list[Json]
    required: bool = True
    # Monotonic seconds.
    begins: float = 0.0
    # Seconds that it takes alone; None: not known.
    undisturbed: float | None = None


class TrueTracks:
    """Asks the simulator twenty times a second, over a port that the server has no part in."""

    def __init__(self, simulator: Simulator) -> None:
        self._simulator = simulator
        self._fixes: dict[str, list[Fix]] = {}
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def fixes(self) -> dict[str, list[Fix]]:
        return {name: list(track) for name, track in self._fixes.items()}

    def down_for(self) -> float:
        """Seconds for which no vehicle has been armed; 0: one is."""
        now = time.monotonic()
        return min(
            (now - next((fix.at for fix in reversed(track) if fix.armed), track[0].at))
            if not track[-1].armed
            else 0.0
            for track in self.fixes().values()
        )

    def close(self) -> None:
        self._closed.set()
        self._thread.join()

    def _run(self) -> None:
        with self._simulator.dial() as port, port.makefile("rw", encoding="utf-8", newline="\n") as line:
            while not self._closed.wait(POLL_SECONDS):
                at = time.monotonic()
                places = _answer(line, "where")
                armed = {words[0] for words in _answer(line, "list") if "armed" in words}
                for name, latitude, longitude, height in places:
                    amsl = GROUND_AMSL_METRES + float(height)
                    fix = Fix(at, float(latitude), float(longitude), amsl, name in armed)
                    self._fixes.setdefault(name, []).append(fix)


def _answer(line: TextIO, command: str) -> list[list[str]]:
    line.write(f"{command}\n")
    line.flush()
    rows = []
    for row in line:
        if row.startswith("ok"):
            break
        rows.append(row.split())
    return rows


def true_fixes(drone: SitlDrone) -> list[Fix]:
    """Of a real autopilot's simulation; it counts as armed from its first metre to its last."""
    positions = drone.autopilot.ground_truth.positions()
    pad = positions[0][3]
    return [Fix(*position, armed=position[3] - pad > 1) for position in positions]


@dataclass
class Flight:
    """Of several operations, as it is judged."""

    name: str
    seed: int
    operations: list[Operation] = field(default_factory=list)

    def judged(self, folder: Path, fixes: dict[str, list[Fix]], moment: float | None = None) -> Verdict:
        """`moment`: when something came between, monotonic."""
        began = max(track[0].at for track in fixes.values())
        folder.mkdir(parents=True, exist_ok=True)
        facts = {
            "scenario": self.name,
            "seed": self.seed,
            "mechanism": True,
            "served": 3.0,
            "operations": [_facts(operation, began) for operation in self.operations],
        }
        if moment is not None:
            facts["moment"] = moment - began
        (folder / "facts.json").write_text(json.dumps(facts), encoding="utf-8")
        lines = [",".join(COLUMNS)]
        for vehicle, track in fixes.items():
            lines += _rows(self.seed, vehicle, track, began)
        (folder / "tracks.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
        return judge_folder(folder, Limits())


def _facts(operation: Operation, began: float) -> Json:
    return {
        "name": operation.name,
        "begins": max(0.0, operation.begins - began),
        "undisturbed": operation.undisturbed,
        "required": operation.required,
        "vehicles": operation.vehicles,
        "waypoints": operation.waypoints,
    }


def _rows(seed: int, vehicle: str, track: list[Fix], began: float) -> list[str]:
    rows: list[str] = []
    newest, step = 0, 0
    while True:
        at = began + step / STEPS_PER_SECOND
        while newest + 1 < len(track) and track[newest + 1].at <= at:
            newest += 1
        if newest + 1 == len(track):
            return rows
        here, there = track[newest], track[newest + 1]
        gap = there.at - here.at
        assert gap <= LONGEST_GAP_SECONDS, f"{vehicle} was not looked at for {gap:.1f} s"
        share = (at - here.at) / gap
        latitude = here.latitude + share * (there.latitude - here.latitude)
        longitude = here.longitude + share * (there.longitude - here.longitude)
        amsl = here.amsl + share * (there.amsl - here.amsl)
        above = amsl - track[0].amsl
        place = f"{latitude:.9f},{longitude:.9f},{amsl:.3f},{above:.3f}"
        rows.append(f"{seed},{step / STEPS_PER_SECOND:.1f},{vehicle},{place},{int(here.armed)}")
        step += 1
