"""A server in memory for tests of programs: no network, no vehicles, and whatever goes wrong on demand."""

import asyncio
import itertools
import json
from collections.abc import Mapping
from contextlib import AbstractAsyncContextManager
from datetime import UTC, datetime, timedelta
from typing import Any

from dronemap.errors import AnswerLost, Unreachable
from dronemap.transport import HttpAnswer, StreamClosed, StreamSocket
from dronemap.version import VERSION

Json = dict[str, Any]
_NO_CONTENT = 204


class MockTransport:
    """A server in memory, for `Dronemap.connect(transport=MockTransport())`.

    Drones do at once what they are told. What a test wants otherwise it says beforehand: `refuse`, `end_commands_as`,
    `answer`, `lose_answers`, `cut`. `commands` and `requests` are what has come.
    """

    def __init__(self) -> None:
        self.requests: list[tuple[str, str, Any]] = []
        """Method, path below /api/v1, and body of each request."""
        self.commands: list[Json] = []
        """Each command as it came, with `drone`; one that comes twice under one id stands here once."""
        self._drones: dict[str, Json] = {}
        self._answers: dict[tuple[str, str], tuple[int, Any]] = {}
        self._refused: dict[str, Json] = {}
        self._outcome: Json = {"result": "succeeded", "by": None, "code": None, "reason": None}
        self._known: dict[str, Json] = {}
        self._lost: dict[str, int] = {}
        self._events: list[Json] = []
        self._lost_through = 0
        self._away = False
        self._sockets: list[_MockSocket] = []
        self._epochs = itertools.count(1)
        self._numbers = itertools.count(1)
        self._now = datetime(2026, 1, 1, tzinfo=UTC)

    def add_drone(self, name: str, latitude: float = 47.3977, longitude: float = 8.5456, **members: Any) -> str:
        """Adds a drone that stands there ready to fly; `members` as the contract has them. Its id."""
        id = f"mock-{next(self._numbers)}"
        place = {"latitude": latitude, "longitude": longitude, "altitudeAboveHome": 0.0, "altitudeAmsl": 488.0}
        self._drones[id] = _drone(id, name, self._time()) | {"position": place} | members
        self._tell_of(id)
        return id

    def change(self, drone: str, **members: Any) -> None:
        """Changes members of a drone as the contract has them, and tells all who watch."""
        self._drones[drone] |= members | {"lastUpdate": self._time()}
        self._tell_of(drone)

    def refuse(self, command: str, code: str, reason: str) -> None:
        """Commands of that type are refused from now on, as the server itself does it."""
        self._refused[command] = {"status": 409, "code": code, "detail": reason}

    def end_commands_as(self, result: str, reason: str | None = None, by: str | None = "vehicle") -> None:
        """How commands end from now on: succeeded, refused, failed, timedOut, superseded or unknown."""
        self._outcome = {"result": result, "by": by, "code": None, "reason": reason}

    def answer(self, method: str, path: str, body: Any, status: int = 200) -> None:
        """What a path below /api/v1 is answered with from now on; bytes as they are, anything else as JSON."""
        self._answers[method, path] = (status, body)

    def lose_answers(self, method: str, times: int) -> None:
        """The next requests of that method are carried out, and their answers lost."""
        self._lost[method] = times

    def go_away(self) -> None:
        """Nobody can reach the server any more; `come_back` ends that."""
        self._away = True
        self.cut()

    def come_back(self) -> None:
        self._away = False

    def add_event(self, drone: str, text: str, kind: str = "message") -> int:
        """Something that happened to that drone; its number."""
        number = next(self._numbers)
        self._events.append({"number": number, "drone": drone, "at": self._time(), "kind": kind, "text": text})
        return number

    def lose_events(self, through: int) -> None:
        """Events up to that number are kept no more."""
        self._events = [event for event in self._events if event["number"] > through]
        self._lost_through = through

    def cut(self) -> None:
        """Ends all streams; clients come again."""
        for socket in self._sockets:
            socket.end()
        self._sockets = []

    def tell(self, message: Json) -> None:
        """Says that on all streams."""
        for socket in self._sockets:
            socket.put(json.dumps(message))

    async def request(
        self,
        method: str,
        path: str,
        *,
        query: Mapping[str, str],
        content: bytes | None = None,
        content_type: str | None = None,
    ) -> HttpAnswer:
        if self._away:
            raise Unreachable("The server in memory is away.")
        body = json.loads(content) if content and content_type == "application/json" else content
        self.requests.append((method, path, body))
        if path == "/events" and ("GET", path) not in self._answers:
            await self._wait_for_events(query)
        status, answered = self._answer_to(method, path, body, query)
        if self._lost.get(method, 0) > 0:
            self._lost[method] -= 1
            raise AnswerLost("The answer was lost, as the test wanted it.")
        text = answered if isinstance(answered, bytes) else json.dumps(answered).encode()
        return HttpAnswer(status, {"dronemap-version": VERSION}, b"" if status == _NO_CONTENT else text)

    def stream(self, port: int) -> AbstractAsyncContextManager[StreamSocket]:
        return _Opening(self)

    async def close(self) -> None:
        self.cut()

    def open_socket(self) -> "_MockSocket":
        if self._away:
            raise StreamClosed("The server in memory is away.")
        socket = _MockSocket()
        socket.put(json.dumps({"type": "hello", "user": "tester", "role": "administrator"}))
        socket.put(json.dumps({"type": "drones", "drones": list(self._drones.values())}))
        self._sockets.append(socket)
        return socket

    def _answer_to(self, method: str, path: str, body: Any, query: Mapping[str, str]) -> tuple[int, Any]:
        if (method, path) in self._answers:
            return self._answers[method, path]
        match (method, *path.strip("/").split("/")):
            case ("GET", "settings"):
                version = {"version": VERSION, "streamPort": 1, "publicMode": False}
                return 200, version | {"phonePage": None, "tileAddress": None}
            case ("GET", "events"):
                return 200, self._page(query)
            case ("GET", "drones"):
                return 200, {"drones": list(self._drones.values())}
            case ("GET", "drones", id) if id in self._drones:
                return 200, self._drones[id]
            case ("POST", "drones", id, "commands") if id in self._drones:
                return self._command(id, body)
            case ("GET", "commands", id) if id in self._known:
                return 200, self._known[id]
            case (_, "drones", id, "control", *action) if id in self._drones:
                return 200, self._control(id, method, action, body)
        detail = f"The server in memory answers nothing to {method} {path}: say what with answer()."
        return 404, {"status": 404, "code": "mock", "detail": detail}

    async def _wait_for_events(self, query: Mapping[str, str]) -> None:
        until = asyncio.get_running_loop().time() + float(query.get("wait", 0))
        while not self._away and not self._page(query)["events"] and asyncio.get_running_loop().time() < until:
            await asyncio.sleep(0.01)
        if self._away:
            raise AnswerLost("The server in memory went away meanwhile.")

    def _page(self, query: Mapping[str, str]) -> Json:
        newest = self._events[-1]["number"] if self._events else self._lost_through
        asked = query.get("after", str(newest))
        after = 0 if asked == "first" else int(asked)
        gap = {"after": self._lost_through, "cause": "expired", "text": "They were kept for long enough."}
        gaps = [gap | {"from": None, "until": None, "count": None}] if after < self._lost_through else []
        events = [event for event in self._events if event["number"] > after][: int(query.get("limit", 100))]
        last = events[-1]["number"] if events else max(after, self._lost_through)
        return {"events": events, "gaps": gaps, "next": str(last)}

    def _command(self, drone: str, body: Json) -> tuple[int, Any]:
        refusal = self._refused.get(body["type"])
        if refusal is not None:
            return refusal["status"], refusal | {"commandId": body.get("id", "mock")}
        id = body.get("id") or f"mock-command-{next(self._numbers)}"
        if id not in self._known:
            self.commands.append(body | {"drone": drone})
            self._known[id] = _command(id, drone, body["type"], self._time())
            done = self._known[id] | {"phase": "done", "outcome": self._outcome, "finishedAt": self._time()}
            if self._outcome["result"] == "succeeded":
                self._obey(drone, body)
            answered = self._known[id]
            self._known[id] = done
            self.tell({"type": "command", "command": done})
            return 202, answered
        return 202, self._known[id]

    def _obey(self, drone: str, body: Json) -> None:
        state = self._drones[drone]
        place = state["position"]
        match body["type"]:
            case "arm":
                self.change(drone, armed=True)
            case "disarm":
                self.change(drone, armed=False)
            case "takeOff":
                self.change(drone, flight="inAir", position=place | {"altitudeAboveHome": body["altitude"]})
            case "goTo":
                to = {"latitude": body["latitude"], "longitude": body["longitude"]}
                self.change(drone, position=place | to | {"altitudeAboveHome": body["altitude"]})
            case "land" | "returnToLaunch":
                ground = place | {"altitudeAboveHome": 0.0}
                self.change(drone, armed=False, flight="onGround", position=ground)
            case "startMission":
                self.change(drone, flight="inAir", mission={"running": True, "reached": [], "state": "running"})
                self.change(drone, mission={"running": False, "reached": [], "state": "complete"})
            case "setMode":
                self.change(drone, mode=body["mode"])

    def _control(self, drone: str, method: str, action: list[str], body: Any) -> Json:
        control: Json = self._drones[drone]["control"]
        if action in (["take"], ["take-over"]):
            held = {"state": "held", "holder": "tester", "explicit": True, "since": self._time()}
            control = control | held | {"epoch": next(self._epochs)}
            self.change(drone, control=control)
        elif method == "DELETE":
            control = control | {"state": "free", "holder": None, "explicit": False}
            self.change(drone, control=control)
        return control

    def _tell_of(self, drone: str) -> None:
        self.tell({"type": "drone", "drone": self._drones[drone]})

    def _time(self) -> str:
        self._now += timedelta(milliseconds=100)
        return self._now.isoformat()


class _MockSocket:
    def __init__(self) -> None:
        self._waiting: asyncio.Queue[str | None] = asyncio.Queue()
        self.sent: list[Json] = []

    def put(self, text: str) -> None:
        self._waiting.put_nowait(text)

    def end(self) -> None:
        self._waiting.put_nowait(None)

    async def receive(self) -> str:
        text = await self._waiting.get()
        if text is None:
            raise StreamClosed("The stream was cut.")
        return text

    async def send(self, text: str) -> None:
        self.sent.append(json.loads(text))


class _Opening(AbstractAsyncContextManager[StreamSocket]):
    def __init__(self, transport: MockTransport) -> None:
        self._transport = transport

    async def __aenter__(self) -> StreamSocket:
        return self._transport.open_socket()

    async def __aexit__(self, *_: object) -> None:
        return None


def _drone(id: str, name: str, now: str) -> Json:
    """A drone on the ground as the contract has it, with what nobody knows left out."""
    return {
        "id": id,
        "name": name,
        "version": 1,
        "kind": "multicopter",
        "autopilot": "ArduPilot",
        "vehicle": "mock",
        "replay": False,
        "armed": False,
        "readyToArm": True,
        "flight": "onGround",
        "mode": "GUIDED",
        "modes": ["GUIDED", "RTL", "LAND", "AUTO"],
        "actions": {},
        "messages": [],
        "lastUpdate": now,
        "cloudLoss": {"state": "set", "sentence": "It comes home by itself.", "outstanding": []},
        "control": {"state": "free", "epoch": 0, "explicit": False, "holder": None, "requests": [], "since": None},
        "identity": {"evidence": "address", "proved": False, "hardwareId": None},
        "link": {
            "state": "live",
            "address": "127.0.0.1",
            "port": 1,
            "systemId": 1,
            "transport": "udp",
            "others": [],
            "outdated": [],
            "quality": {},
        },
        "mission": {"running": False, "reached": []},
    }


def _command(id: str, drone: str, kind: str, now: str) -> Json:
    command = {"id": id, "drone": drone, "type": kind, "summary": kind, "by": "tester", "face": "rest"}
    return command | {"at": now, "phase": "sent", "warnings": [], "outcome": None}
