"""A server in memory: it answers what a test has put into it, and remembers what it was asked."""

import asyncio
import json
from collections.abc import Callable, Mapping
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from dataclasses import dataclass, field
from typing import Any

from click.testing import CliRunner, Result

from dronectl.__main__ import main
from dronectl.settings import Settings
from dronemap import Unreachable
from dronemap.transport import HttpAnswer, StreamClosed, StreamSocket

NOW = "2026-03-04T05:06:07Z"
Members = dict[str, Any]
Answer = Members | list[Any] | bytes | int | Exception | None


@dataclass(frozen=True)
class Asked:
    """A request as it was sent."""

    method: str
    path: str
    query: Mapping[str, str]
    content: bytes | None
    content_type: str | None

    @property
    def body(self) -> Any:
        return json.loads(self.content or b"null")


@dataclass
class FakeServer:
    """Implements the transport: `answers` by method and path below /api/v1; a function is called with the request."""

    answers: dict[str, Any] = field(default_factory=dict)
    drones: list[Members] = field(default_factory=list)
    asked: list[Asked] = field(default_factory=list)
    on_command: Callable[["FakeServer", Members], None] = lambda server, command: None
    away: bool = False
    mute: bool = False
    """No stream is to be had."""

    def __post_init__(self) -> None:
        self._told: list[asyncio.Queue[Members]] = []
        self._waiting: list[Members] = []

    async def request(
        self,
        method: str,
        path: str,
        *,
        query: Mapping[str, str],
        content: bytes | None = None,
        content_type: str | None = None,
    ) -> HttpAnswer:
        if self.away:
            raise Unreachable("http://127.0.0.1:1 cannot be reached: refused")
        asked = Asked(method, path, query, content, content_type)
        self.asked.append(asked)
        # As on a network, whatever else is to be done is done before the answer comes.
        await asyncio.sleep(0.01)
        answer = self.answers.get(f"{method} {path}", self._usual(asked))
        if callable(answer):
            answer = answer(asked)
        if isinstance(answer, Exception):
            raise answer
        if method == "POST" and path.endswith("/commands"):
            self.on_command(self, asked.body)
            await asyncio.sleep(0.01)
        return _http(answer)

    def stream(self, port: int) -> AbstractAsyncContextManager[StreamSocket]:
        return self._streamed()

    async def close(self) -> None:
        return None

    def tell(self, message: Members) -> None:
        """On the stream, to all who read it by now or begin to."""
        if not self._told:
            self._waiting.append(message)
        for told in self._told:
            told.put_nowait(message)

    def fly(self, **changes: Any) -> None:
        """The first drone is now like that, and the stream says so."""
        self.drones[0] = self.drones[0] | changes
        self.tell({"type": "drone", "drone": self.drones[0]})

    def last(self, method: str, path: str) -> Asked:
        fitting = [asked for asked in self.asked if (asked.method, asked.path) == (method, path)]
        assert fitting, f"Nobody asked {method} {path}, but {[f'{a.method} {a.path}' for a in self.asked]}"
        return fitting[-1]

    def commands(self) -> list[Members]:
        """All commands that were given to the first drone."""
        path = f"/drones/{self.drones[0]['id']}/commands"
        return [asked.body for asked in self.asked if (asked.method, asked.path) == ("POST", path)]

    def _usual(self, asked: Asked) -> Answer:
        if asked.path == "/settings":
            return {"publicMode": False, "streamPort": 1, "version": "0.9"}
        if (asked.method, asked.path) == ("GET", "/drones"):
            return {"drones": self.drones}
        if asked.method == "POST" and asked.path.endswith("/commands"):
            return command(asked.body["type"], id=asked.body["id"])
        return problem(404, f"There is nothing at {asked.path}.", "not-found")

    @asynccontextmanager
    async def _streamed(self) -> Any:
        if self.mute:
            raise StreamClosed("mute")
        told: asyncio.Queue[Members] = asyncio.Queue()
        self._told.append(told)
        told.put_nowait({"type": "drones", "drones": list(self.drones)})
        for message in self._waiting:
            told.put_nowait(message)
        self._waiting.clear()
        try:
            yield _Socket(told)
        finally:
            self._told.remove(told)


class _Socket:
    def __init__(self, told: asyncio.Queue[Members]) -> None:
        self._told = told

    async def receive(self) -> str | bytes:
        return json.dumps(await self._told.get())

    async def send(self, text: str) -> None:
        return None


def problem(status: int, detail: str, code: str, **further: Any) -> Members:
    return {"_status": status, "detail": detail, "code": code, **further}


def _http(answer: Any) -> HttpAnswer:
    headers = {"dronemap-version": "0.9"}
    if isinstance(answer, bytes):
        return HttpAnswer(200, headers, answer)
    if answer is None:
        return HttpAnswer(204, headers, b"")
    status = answer.pop("_status", 200) if isinstance(answer, dict) and "_status" in answer else 200
    return HttpAnswer(status, headers, json.dumps(answer).encode())


def run(server: FakeServer, *args: str, input: str | None = None) -> Result:
    """dronectl with these arguments against that server; errors become codes as they do in the shell."""
    return CliRunner().invoke(shell, args, input=input, obj=Settings(transport=server))


class _Shell:
    """What CliRunner needs of a command: dronectl as it is run by a shell."""

    name = "dronectl"

    def main(self, args: list[str], prog_name: str, obj: Settings, **_: Any) -> None:
        main(args, obj)


shell: Any = _Shell()


def drone(id: str = "d1", name: str = "Heron-1", **members: Any) -> Members:
    return {
        "actions": {},
        "armed": False,
        "autopilot": "ArduPilot",
        "cloudLoss": {"state": "set", "sentence": "It comes home by itself.", "outstanding": []},
        "control": {"epoch": 1, "explicit": False, "requests": [], "state": "free"},
        "flight": "onGround",
        "id": id,
        "identity": {"evidence": "link", "proved": True},
        "kind": "multicopter",
        "lastUpdate": NOW,
        "link": {
            "address": "127.0.0.1",
            "others": [],
            "outdated": [],
            "port": 1,
            "quality": {},
            "trend": {"state": "steady", "secondsLeft": None, "sentence": "Its link is as it usually is."},
            "state": "live",
            "systemId": 1,
            "transport": "udp",
        },
        "messages": [],
        "mission": {"reached": [], "running": False},
        "mode": "GUIDED",
        "modes": ["GUIDED"],
        "name": name,
        "position": {"latitude": 47.0, "longitude": 8.0, "altitudeAboveHome": 0.0, "altitudeAmsl": 400.0},
        "replay": False,
        "vehicle": "quad",
        "version": 1,
    } | members


def command(kind: str, id: str = "command-1", result: str | None = "succeeded", **members: Any) -> Members:
    outcome = None if result is None else {"result": result}
    return {
        "at": NOW,
        "by": "anna",
        "drone": "d1",
        "face": "rest",
        "id": id,
        "outcome": outcome,
        "phase": "sent" if result is None else "done",
        "summary": kind,
        "type": kind,
        "warnings": [],
    } | members
