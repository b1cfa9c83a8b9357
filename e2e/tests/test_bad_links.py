"""Commands over a link that delays by 500 ± 200 ms, loses a tenth each way, doubles and reorders."""

import random
import threading
from collections import Counter, deque
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.impairer import BAD, Impairer
from dronemap_e2e.peer import Peer, set_mode
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for

GUIDED, LOITER, BRAKE = 4, 5, 17
# Doing these twice is once too often.
ONCE = {
    mavlink.MAV_CMD_IMAGE_START_CAPTURE: "takePicture",
    mavlink.MAV_CMD_DO_SET_RELAY: "setRelay",
    mavlink.MAV_CMD_CONDITION_YAW: "turn",
}
REPEATABLE = {mavlink.MAV_CMD_DO_SET_MODE: "setMode", mavlink.MAV_CMD_DO_REPOSITION: "goTo"}


class CountingCopter:
    """A copter in the air that carries out whatever reaches it, as often as it does, and writes it down."""

    def __init__(self, port: int, system_id: int) -> None:
        self.log: list[tuple[str, tuple[float, ...]]] = []
        self.system_id = system_id
        self._frames: deque[tuple[int, int]] = deque(maxlen=64)
        self._lock = threading.Lock()
        handlers = {"COMMAND_LONG": self._obey, "COMMAND_INT": self._obey}
        self.peer = Peer(port, system_id=system_id, handlers=handlers)
        self.peer.state.armed = True
        self.peer.state.custom_mode = GUIDED
        self.peer.state.status = mavlink.MAV_STATE_ACTIVE

    def executed(self, kind: str) -> list[tuple[float, ...]]:
        with self._lock:
            return [parameters for name, parameters in self.log if name == kind]

    def _obey(self, peer: Peer, message: Any) -> None:
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
            self.log.append((kind, _parameters(message)))
        peer.acknowledge(message)
        peer.beat()


def _parameters(message: Any) -> tuple[float, ...]:
    if message.get_type() == "COMMAND_INT":
        return (message.x, message.y)
    return (message.param1, message.param2, message.param3)


@dataclass(frozen=True)
class Line:
    """One command as the server ended it, beside how often the vehicle carried it out meanwhile."""

    body: Json
    outcome: Json
    executions: int


@pytest.fixture
def link(server: Server) -> Iterator[Impairer]:
    made = Impairer(server.udp_port, seed=20)
    yield made
    made.close()


def fly(api: Api, copter: CountingCopter, drone: str, commands: list[Json]) -> list[Line]:
    lines = []
    for body in commands:
        before = len(copter.executed(body["type"]))
        record = api.command(drone, body)
        assert record["outcome"] is not None, record
        lines.append(Line(body, record["outcome"], len(copter.executed(body["type"])) - before))
    return lines


def mixed(count: int, seed: int) -> list[Json]:
    """Every kind in turn; no two of one drone are alike, so that the peer's log tells them apart."""
    rng = random.Random(seed)
    kinds: list[Json] = []
    for number in range(count):
        kinds.append(
            (
                {"type": "takePicture"},
                {"type": "setMode", "mode": rng.choice(["LOITER", "BRAKE"])},
                {"type": "setRelay", "relay": number % 16, "setting": "toggle"},
                {"type": "goTo", "latitude": 47.3 + number / 1e5, "longitude": 8.5, "altitude": 30},
                {"type": "turn", "degrees": (number % 359 + 1) * rng.choice([-1, 1])},
            )[number % 5]
        )
    return kinds


@pytest.mark.parametrize(
    ("drones", "each"),
    [(10, 10), pytest.param(20, 50, marks=pytest.mark.soak)],
    ids=["a hundred commands", "a thousand commands"],
)
def test_outcomes_agree_with_what_the_vehicles_did(
    server: Server, api: Api, link: Impairer, drones: int, each: int
) -> None:
    copters = [CountingCopter(link.port, 150 + number) for number in range(drones)]
    try:
        ids = {copter.system_id: _listed(api, link, copter) for copter in copters}
        link.weather = BAD
        with ThreadPoolExecutor(drones) as pool:
            # One connection for each thread: a session of requests is not made for many.
            flown = pool.map(
                lambda copter: fly(
                    Api(server.address, server.local_key()),
                    copter,
                    ids[copter.system_id],
                    mixed(each, seed=copter.system_id),
                ),
                copters,
            )
            lines = [line for of_one in flown for line in of_one]
    finally:
        for copter in copters:
            copter.peer.close()
    _judge(lines, drones * each)


def _judge(lines: list[Line], expected: int) -> None:
    results = Counter((line.body["type"], line.outcome["result"]) for line in lines)
    print(sorted(results.items()))
    once = set(ONCE.values())
    for line in lines:
        result = line.outcome["result"]
        if line.body["type"] in once:
            assert line.executions <= 1, line
            assert result in ("succeeded", "unknown"), line
            assert result != "succeeded" or line.executions == 1, line
        elif result == "succeeded":
            assert line.executions >= 1 or line.body["type"] == "setMode", line
    assert len(lines) == expected
    others = [line for line in lines if line.outcome["result"] not in ("succeeded", "unknown")]
    repeatable_unknown = [
        line for line in lines if line.outcome["result"] == "unknown" and line.body["type"] not in once
    ]
    assert len(others) + len(repeatable_unknown) <= expected / 1000, others + repeatable_unknown


def _listed(api: Api, link: Impairer, copter: CountingCopter) -> str:
    def find() -> str | None:
        port = link.seen_by_server(copter.peer.port)
        return next(
            (
                str(d["id"])
                for d in api.drones()
                if d["link"]["port"] == port and d["armed"] and d["flight"] == "inAir"
            ),
            None,
        )

    return wait_for("the copter is listed in the air", find, 30)
