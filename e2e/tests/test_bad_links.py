"""Commands over a link that delays by 500 ± 200 ms, loses a tenth each way, doubles and reorders."""

import random
import threading
import time
from collections import Counter, deque
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.impairer import BAD, Impairer
from dronemap_e2e.peer import Peer, set_mode
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for

GUIDED = 4
MODES = {"LOITER": 5, "BRAKE": 17}
# Doing these twice is once too often.
ONCE = {
    mavlink.MAV_CMD_IMAGE_START_CAPTURE: "takePicture",
    mavlink.MAV_CMD_DO_SET_RELAY: "setRelay",
    mavlink.MAV_CMD_CONDITION_YAW: "turn",
}
REPEATABLE = {mavlink.MAV_CMD_DO_SET_MODE: "setMode", mavlink.MAV_CMD_DO_REPOSITION: "goTo"}


@dataclass(frozen=True)
class ExecutedCommand:
    """One line of a vehicle's log: what it carried out, and when."""

    at: float
    kind: str
    parameters: tuple[float, ...]


class CountingCopter:
    """A copter in the air that carries out whatever reaches it, as often as it does, and writes it down."""

    def __init__(self, port: int, system_id: int) -> None:
        self.system_id = system_id
        self._log: list[ExecutedCommand] = []
        self._frames: deque[tuple[int, int]] = deque(maxlen=64)
        self._lock = threading.Lock()
        handlers = {"COMMAND_LONG": self._apply_command, "COMMAND_INT": self._apply_command}
        self.peer = Peer(port, system_id=system_id, handlers=handlers)
        self.peer.state.armed = True
        self.peer.state.custom_mode = GUIDED
        self.peer.state.status = mavlink.MAV_STATE_ACTIVE

    def log(self) -> list[ExecutedCommand]:
        with self._lock:
            return list(self._log)

    def _apply_command(self, peer: Peer, message: Any) -> None:
        frame = (message.get_header().seq, message.get_crc())
        if frame in self._frames:
            return  # the network's own duplicate, as a receiver that looks at sequence numbers knows
        self._frames.append(frame)
        kind = ONCE.get(message.command) or REPEATABLE.get(message.command)
        if kind is None:
            peer.acknowledge(message, mavlink.MAV_RESULT_UNSUPPORTED)
            return
        if kind == "setMode":
            set_mode(peer, int(message.param2), 0)
        with self._lock:
            self._log.append(ExecutedCommand(time.monotonic(), kind, _parameters(message)))
        peer.acknowledge(message)
        peer.beat()


def _parameters(message: Any) -> tuple[float, ...]:
    if message.get_type() == "COMMAND_INT":
        return (message.x, message.y)
    return (message.param1, message.param2, message.param3)


@dataclass(frozen=True)
class EndedCommand:
    """One command of one drone as the server ended it."""

    at: float
    body: Json
    outcome: Json

    def matches(self, executed: ExecutedCommand) -> bool:
        """True if that is what the vehicle does when it carries this command out."""
        body, parameters = self.body, executed.parameters
        if body["type"] != executed.kind:
            return False
        if executed.kind == "setMode":
            return bool(parameters[1] == MODES[body["mode"]])
        if executed.kind == "setRelay":
            return bool(parameters[0] == body["relay"])
        if executed.kind == "turn":
            return bool(parameters[0] == abs(body["degrees"]) and parameters[2] * body["degrees"] > 0)
        if executed.kind == "goTo":
            return bool(abs(parameters[0] - body["latitude"] * 1e7) < 2)
        return True  # a picture is like the other


@dataclass(frozen=True)
class Comparison:
    """One command beside its executions in the vehicle's own log."""

    body: Json
    outcome: Json
    executions: int


@pytest.fixture
def link(server: Server) -> Iterator[Impairer]:
    made = Impairer(server.udp_port, seed=20)
    yield made
    made.close()


def fly(api: Api, drone: str, commands: list[Json]) -> list[EndedCommand]:
    ended = []
    for body in commands:
        began = time.monotonic()
        record = api.command(drone, body)
        assert record["outcome"] is not None, record
        ended.append(EndedCommand(began, body, record["outcome"]))
    return ended


def compare(ended: list[EndedCommand], log: list[ExecutedCommand]) -> list[Comparison]:
    """The outcomes line by line beside the log, whose every line must belong to a command."""
    executions = [0] * len(ended)
    for executed in log:
        likely = [n for n, one in enumerate(ended) if one.at <= executed.at and one.matches(executed)]
        # Going somewhere may begin with the mode that this needs.
        assert likely or (executed.kind == "setMode" and int(executed.parameters[1]) == GUIDED), executed
        if likely:
            executions[likely[-1]] += 1
    return [Comparison(one.body, one.outcome, count) for one, count in zip(ended, executions, strict=True)]


def mixed(count: int, seed: int) -> list[Json]:
    """Every kind in turn; like ones of one drone lie far apart, so that its log tells them apart."""
    rng = random.Random(seed)
    kinds: list[Json] = []
    for number in range(count):
        kinds.append(
            (
                {"type": "takePicture"},
                {"type": "setMode", "mode": ("LOITER", "BRAKE")[number // 5 % 2]},
                {"type": "setRelay", "relay": number % 16, "setting": "toggle"},
                {"type": "goTo", "latitude": 47.3 + number / 1e5, "longitude": 8.5, "altitude": 30},
                {"type": "turn", "degrees": (number % 359 + 1) * rng.choice([-1, 1])},
            )[number % 5]
        )
    return kinds


@pytest.mark.soak
@pytest.mark.parametrize(("drones", "each"), [(20, 50)], ids=["a thousand commands"])
def test_command_outcomes_match_vehicle_logs(
    server: Server, api: Api, link: Impairer, drones: int, each: int
) -> None:
    copters = [CountingCopter(link.port, 150 + number) for number in range(drones)]
    try:
        ids = {copter.system_id: _listed(api, link, copter) for copter in copters}
        link.conditions = BAD
        with ThreadPoolExecutor(drones) as pool:
            # One connection for each thread: a session of requests is not made for many.
            flown = list(
                pool.map(
                    lambda copter: fly(
                        Api(server.address, server.local_key()),
                        ids[copter.system_id],
                        mixed(each, seed=copter.system_id),
                    ),
                    copters,
                )
            )
        # Whatever was on its way when the last outcome came has arrived by then, and may act.
        for _ in "there", "and back":
            wait_for("all has arrived", partial(link.arrived, link.newest()))
        lines = [
            line
            for copter, ended in zip(copters, flown, strict=True)
            for line in compare(ended, copter.log())
        ]
    finally:
        for copter in copters:
            copter.peer.close()
    _check(lines, drones * each)


def _check(lines: list[Comparison], expected: int) -> None:
    results = Counter((line.body["type"], line.outcome["result"], line.executions) for line in lines)
    print(*sorted(results.items()), sep="\n")
    assert len(lines) == expected
    once = set(ONCE.values())
    for line in lines:
        result = line.outcome["result"]
        if line.body["type"] in once:
            assert line.executions <= 1, line
        if result == "succeeded":
            assert line.executions >= 1, line
        elif result != "unknown":
            assert line.executions == 0, line
    good = [
        line
        for line in lines
        if line.outcome["result"] == "succeeded"
        or (line.outcome["result"] == "unknown" and line.body["type"] in once)
    ]
    assert len(good) >= expected * 999 / 1000, [line for line in lines if line not in good]


def _listed(api: Api, link: Impairer, copter: CountingCopter) -> str:
    def find() -> str | None:
        port = link.server_side_port(copter.peer.port)
        return next(
            (
                str(d["id"])
                for d in api.drones()
                if d["link"]["port"] == port and d["armed"] and d["flight"] == "inAir"
            ),
            None,
        )

    return wait_for("the copter is listed in the air", find, 30)
