"""Two clients who want one drone at once, each through its own face, and the judge at the vehicle."""

import bisect
import json
import random
import secrets
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol

from pymavlink.dialects.v20 import ardupilotmega as mavlink
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from .api import Api, Json
from .peer import Peer

GUIDED = 4
STEP = 1e-5
QUIET_SECONDS = 1.2


@dataclass(frozen=True)
class Move:
    """A go-to that only one command asked for: its latitude names it."""

    number: int

    @property
    def body(self) -> Json:
        return {"type": "goTo", "latitude": 10 + self.number * STEP, "longitude": 8.0, "altitude": 20}

    @staticmethod
    def of(message: Any) -> "Move":
        return Move(round((message.x / 1e7 - 10) / STEP))


@dataclass(frozen=True)
class ReceivedMove:
    """A go-to at the vehicle's socket, and when it came there (seconds of the clock)."""

    move: Move
    at: float


class HoveringCopter:
    """A copter in the air, guided, and slow to acknowledge: most commands are repeated."""

    def __init__(self, port: int, system_id: int) -> None:
        self.moves: list[ReceivedMove] = []
        self.peer = Peer(
            port,
            system_id=system_id,
            handlers={"COMMAND_INT": self._apply_command, "COMMAND_LONG": self._apply_command},
        )
        self.peer.state.armed = True
        self.peer.state.custom_mode = GUIDED
        self.peer.state.status = mavlink.MAV_STATE_ACTIVE

    def _apply_command(self, peer: Peer, message: Any) -> None:
        if message.command == mavlink.MAV_CMD_DO_SET_MODE:
            peer.state.custom_mode = int(message.param2)
        elif message.command == mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH:
            peer.state.custom_mode = 6
        elif message.command == mavlink.MAV_CMD_DO_REPOSITION and message.get_type() == "COMMAND_INT":
            self.moves.append(ReceivedMove(Move.of(message), peer.arrived))
            if len(self.moves) % 3:
                return
        else:
            peer.acknowledge(message, mavlink.MAV_RESULT_UNSUPPORTED)
            return
        peer.acknowledge(message)
        peer.beat()


class Client(Protocol):
    """A client that takes a drone over or commands it; None: refused, or no answer."""

    def take_over(self) -> int | None: ...

    def move(self, move: Move, command: str) -> Json | None: ...


class RestClient:
    def __init__(self, api: Api, drone: str) -> None:
        self._api = api
        self._drone = drone

    def take_over(self) -> int | None:
        answer = self._api.call("POST", f"/drones/{self._drone}/control/take-over", {"reason": "a race"})
        return int(answer.json()["epoch"]) if answer.ok else None

    def move(self, move: Move, command: str) -> Json | None:
        answer = self._api.call("POST", f"/drones/{self._drone}/commands", {**move.body, "id": command})
        assert answer.status_code in (202, 200, 409), answer.text
        body: Json = answer.json()
        return body if answer.ok else None


class StreamClient:
    def __init__(self, address: str, key: str, drone: str) -> None:
        self._address = address
        self._key = key
        self._drone = drone
        self._socket: ClientConnection | None = None

    def take_over(self) -> int | None:
        answer = self._ask({"type": "control", "action": "takeOver", "reason": "a race"})
        return int(answer["control"]["epoch"]) if "control" in answer else None

    def move(self, move: Move, command: str) -> Json | None:
        answer = self._ask({"type": "command", "command": {**move.body, "id": command}})
        assert answer["type"] == "commandAccepted" or answer["problem"]["status"] == 409, answer
        record: Json | None = answer.get("command")
        return record

    def close(self) -> None:
        if self._socket:
            self._socket.close()

    def _ask(self, message: Json) -> Json:
        try:
            return self._exchange(message)
        except ConnectionClosed:
            self._socket = None
            raise

    def _exchange(self, message: Json) -> Json:
        if self._socket is None:
            headers = {"Authorization": f"Bearer {self._key}"}
            self._socket = connect(self._address, additional_headers=headers)
            self._socket.send(json.dumps({"type": "subscribe", "drones": []}))
        request = f"r{time.monotonic_ns()}"
        self._socket.send(json.dumps({**message, "drone": self._drone, "requestId": request}))
        while True:
            answer: Json = json.loads(self._socket.recv(timeout=60))
            if answer.get("requestId") == request:
                return answer


@dataclass
class QuietPeriod:
    """A time in which nobody commands: what is repeated then is of an epoch that is over."""

    until: float = 0.0

    def wait(self) -> None:
        time.sleep(max(0.0, self.until - time.monotonic()))


@dataclass
class Racer:
    """One side: what it was allowed to send, by the epoch that the server gave it."""

    name: str
    client: Client
    first: int
    seed: int
    allowed: dict[Move, int] = field(default_factory=dict)
    refused: set[Move] = field(default_factory=set)
    taken_over: list[tuple[float, int]] = field(default_factory=list)
    quiet_every: int = 8
    quiet: QuietPeriod = field(default_factory=QuietPeriod)
    prefix: str = field(default_factory=lambda: secrets.token_hex(4))

    def command(self, move: Move) -> str:
        """The id that it gives to the command, by which it is found again after a crash."""
        return f"{self.prefix}-{move.number}"

    def race(self, rounds: int, during: Callable[[int], None] = lambda _: None) -> None:
        chance = random.Random(self.seed)
        number = self.first
        for round_number in range(rounds):
            during(round_number)
            move = Move(number)
            number += 2
            self.quiet.wait()
            self._attempt(move, chance.random() < 0.4)
            time.sleep(chance.random() * 0.01)

    def _take_over(self) -> None:
        epoch = self.client.take_over()
        if epoch is not None:
            self.taken_over.append((time.time(), epoch))
        if len(self.taken_over) % self.quiet_every == 1:
            self.quiet.until = time.monotonic() + QUIET_SECONDS
            self.quiet.wait()

    def _attempt(self, move: Move, takes_over: bool) -> None:
        try:
            if takes_over:
                self._take_over()
            record = self.client.move(move, self.command(move))
        except (OSError, ConnectionClosed, TimeoutError):
            return  # the server is being restarted: whether the command counts is for its record to say
        if record is None:
            self.refused.add(move)
        else:
            self.allowed[move] = record["epoch"]


def race(racers: list[Racer], rounds: int, during: Callable[[int], None] = lambda _: None) -> None:
    """Lets all race at once; `during` is called by the first one before each of its rounds."""
    for racer in racers:
        racer.quiet = racers[0].quiet
    threads = [
        threading.Thread(target=racer.race, args=(rounds, during) if racer is racers[0] else (rounds,))
        for racer in racers
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def fill_epochs_from_records(
    moves: list[ReceivedMove], racers: list[Racer], record: Callable[[str], Json | None]
) -> int:
    """Takes the epochs of commands whose answers were lost from their records. Returns how many."""
    asked = 0
    for move in {seen.move for seen in moves}:
        racer = racers[move.number % len(racers)]
        if move not in racer.allowed and move not in racer.refused:
            found = record(racer.command(move))
            assert found and found["epoch"], f"{move} was sent, and no record of it names its epoch: {found}"
            racer.allowed[move] = found["epoch"]
            asked += 1
    return asked


def check_epochs(moves: list[ReceivedMove], racers: list[Racer]) -> int:
    """Checks what reached the vehicle: no refused command, epochs that never fall, one holder each; and
    nothing of an epoch after somebody had been told of a later one.

    Returns how often control changed hands on the wire.
    """
    holders: dict[int, str] = {}
    newest = 0
    changes = 0
    taken_over = sorted(each for racer in racers for each in racer.taken_over)
    for seen in moves:
        move = seen.move
        racer = racers[move.number % len(racers)]
        assert move not in racer.refused, f"{move} was refused, and sent all the same"
        assert move in racer.allowed, f"nobody was allowed to send {move}"
        epoch = racer.allowed[move]
        assert epoch >= newest, f"{move} of epoch {epoch} was sent after epoch {newest}"
        given = max(
            (later for at, later in taken_over[: bisect.bisect_left(taken_over, (seen.at, 0))][-5:]),
            default=0,
        )
        assert epoch >= given, f"{move} of epoch {epoch} was sent after epoch {given} was given"
        changes += epoch > newest > 0
        newest = epoch
        assert holders.setdefault(epoch, racer.name) == racer.name, f"epoch {epoch} has two holders"
    return changes
