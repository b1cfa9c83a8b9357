"""Each way to command a drone, as one of its own programs does it, with what it says in the same words."""

import json
import os
import re
import secrets
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

import zeep.exceptions
import zeep.helpers
from dronemap import CommandError, Dronemap, Problem, models
from pydantic import TypeAdapter
from websockets.sync.client import connect

from . import java_example
from .api import Api, Json
from .server import ROOT, Server
from .soap import soap

#: Outcome or problem: result or status, by whom, code, sentence, field at fault.
Said = tuple[str | int | None, ...]
SUCCEEDED: Said = ("succeeded", None, None, None)
TYPESCRIPT = ROOT / "sdk-typescript"


class Face(Protocol):
    """A way to command; `command` and `control` say how that ended."""

    def drones(self) -> list[str]: ...

    def control(self, drone: str, operation: str) -> Json:
        """takeControl or releaseControl: the control as it is then."""
        ...

    def command(self, drone: str, body: Json) -> Said: ...

    def close(self) -> None: ...


def outcome(told: Json) -> Said:
    return (told["result"], told["by"], told["code"], told["reason"])


def problem(told: Json) -> Said:
    if told.get("commandId"):
        return ("refused", "gate", told["code"], told["detail"])
    return (None, None, told["code"], told["detail"], told.get("field"))


class RestFace:
    """REST by requests."""

    def __init__(self, server: Server, key: str) -> None:
        self._api = Api(server.address, key)

    def drones(self) -> list[str]:
        return [drone["id"] for drone in self._api.drones()]

    def control(self, drone: str, operation: str) -> Json:
        path = f"/drones/{drone}/control"
        answer = (
            self._api.call("POST", path + "/take")
            if operation == "takeControl"
            else self._api.call("DELETE", path)
        )
        body: Json = answer.json()
        return body

    def command(self, drone: str, body: Json) -> Said:
        asked = body | {"id": secrets.token_urlsafe(12)}
        answer = self._api.call("POST", f"/drones/{drone}/commands?wait=60", asked)
        told = answer.json()
        return outcome(told["outcome"]) if answer.ok else problem(told)

    def close(self) -> None:
        return None


class SoapFace:
    """SOAP by zeep."""

    NAMES = {"takeOff": "takeoff", "goTo": "goto"}

    def __init__(self, server: Server, key: str) -> None:
        self._service = soap(server, key)

    def drones(self) -> list[str]:
        return [drone.id for drone in self._service.getDronesList().item]

    def control(self, drone: str, operation: str) -> Json:
        answer = getattr(self._service, operation)(droneId=drone)
        told: Json = zeep.helpers.serialize_object(answer, dict)  # type: ignore[no-untyped-call]
        return told

    def command(self, drone: str, body: Json) -> Said:
        members = {name: _listed(value) for name, value in body.items() if name != "type"}
        kind = str(body["type"])
        call = getattr(self._service, self.NAMES.get(kind, kind))
        try:
            told = call(droneId=drone, id=secrets.token_urlsafe(12), wait=60, **members).outcome
        except zeep.exceptions.Fault as fault:
            detail = {re.sub(r"^\{.*\}", "", part.tag): part.text for part in fault.detail.iter()}
            return (None, None, detail["code"], fault.message, detail.get("field"))
        return (told.result, told.by, told.code, told.reason)

    def close(self) -> None:
        return None


def _listed(value: Any) -> Any:
    """A list as SOAP has it; a step of a mission by the element of its type."""
    if not isinstance(value, list):
        return value
    steps = [{step["type"]: {name: part for name, part in step.items() if name != "type"}} for step in value]
    return {"item": steps}


class StreamFace:
    """The stream by websockets."""

    def __init__(self, server: Server, key: str) -> None:
        headers = {"Authorization": f"Bearer {key}"}
        # Without a bound: what nobody reads would keep its end waiting.
        self._stream = connect(server.stream_address, additional_headers=headers, max_queue=None)

    def drones(self) -> list[str]:
        return [drone["id"] for drone in self._next(lambda m: m["type"] == "drones")["drones"]]

    def control(self, drone: str, operation: str) -> Json:
        action = {"takeControl": "take", "releaseControl": "release"}[operation]
        told: Json = self._asked({"type": "control", "drone": drone, "action": action})["control"]
        return told

    def command(self, drone: str, body: Json) -> Said:
        own = body | {"id": secrets.token_urlsafe(12)}
        answer = self._asked({"type": "command", "drone": drone, "command": own})
        if answer["type"] == "error":
            return problem(answer["problem"])
        ended = self._next(
            lambda m: (
                m["type"] == "command"
                and m["command"]["id"] == own["id"]
                and m["command"]["outcome"] is not None
            )
        )
        return outcome(ended["command"]["outcome"])

    def _asked(self, request: Json) -> Json:
        number = secrets.token_hex(4)
        self._stream.send(json.dumps(request | {"requestId": number}))
        return self._next(lambda m: m.get("requestId") == number)

    def _next(self, wanted: Callable[[Json], bool]) -> Json:
        while True:
            message: Json = json.loads(self._stream.recv(timeout=60))
            if wanted(message):
                return message

    def close(self) -> None:
        self._stream.close()


class PythonFace:
    """The client for Python."""

    def __init__(self, server: Server, key: str) -> None:
        self._connected = Dronemap.connect(server.address, key)

    def drones(self) -> list[str]:
        return [drone.id for drone in self._connected.drones()]

    def control(self, drone: str, operation: str) -> Json:
        rest = self._connected.rest
        call = rest.take_control if operation == "takeControl" else rest.release_control
        return call(drone).model_dump(by_alias=True)

    def command(self, drone: str, body: Json) -> Said:
        kind: TypeAdapter[Any] = TypeAdapter(models.CommandRequest)
        try:
            self._connected.drone(drone).give(kind.validate_python(body)).wait(60)
        except CommandError as error:
            result = type(error).__name__
            return (result[0].lower() + result[1:], error.by, error.code, error.reason)
        except Problem as error:
            return (None, None, error.code, str(error), error.field)
        return SUCCEEDED

    def close(self) -> None:
        self._connected.close()


class LineDriverFace:
    """A program of another language, which is told by lines what to do."""

    def __init__(self, server: Server, key: str, *program: str | Path) -> None:
        self._program = subprocess.Popen(
            program,
            env=_environment(server, key),
            text=True,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )

    def drones(self) -> list[str]:
        listed: list[str] = self._asked({"do": "list"})
        return listed

    def control(self, drone: str, operation: str) -> Json:
        told: Json = self._asked({"do": "rest", "operation": operation, "parameters": {"id": drone}})
        return told

    def command(self, drone: str, body: Json) -> Said:
        told = self._asked({"do": "command", "drone": drone, "body": body})
        return outcome(told) if "result" in told else problem(told)

    def _asked(self, request: Json) -> Any:
        assert self._program.stdin is not None
        assert self._program.stdout is not None
        self._program.stdin.write(json.dumps(request) + "\n")
        self._program.stdin.flush()
        return json.loads(self._program.stdout.readline())

    def close(self) -> None:
        assert self._program.stdin is not None
        self._program.stdin.close()
        self._program.wait(10)


class TypeScriptFace(LineDriverFace):
    """The client for TypeScript, in Node."""

    def __init__(self, server: Server, key: str) -> None:
        driver = TYPESCRIPT / "dev" / "line-driver.ts"
        super().__init__(server, key, TYPESCRIPT / "node_modules" / ".bin" / "tsx", driver)


class JavaFace(LineDriverFace):
    """The classes that the Java example generates, of REST or of SOAP."""

    def __init__(self, server: Server, key: str, interface: str) -> None:
        example = java_example.built(server)
        super().__init__(
            server, key, *example.java, ROOT / "e2e" / "dronemap_e2e" / "LineDriver.java", interface
        )


class CommandLineFace:
    """dronectl, a process for each command."""

    def __init__(self, server: Server, key: str, folder: Path) -> None:
        self._environment = _environment(server, key) | {"PYTHONPATH": str(ROOT / "sdk-python")}
        self._folder = folder

    def drones(self) -> list[str]:
        return [drone["id"] for drone in json.loads(self._run("drones", "--json").stdout)["drones"]]

    def control(self, drone: str, operation: str) -> Json:
        done = self._run("call", operation, f"id={drone}")
        assert done.returncode == 0, done.stderr
        told: Json = json.loads(done.stdout)
        return told

    def command(self, drone: str, body: Json) -> Said:
        done = self._run(*self._words(body), "--drone", drone)
        if done.returncode == 0:
            return SUCCEEDED
        told = re.fullmatch(r"dronectl: (?:(\w+): )?(.*) \[([a-z-]+)\]\n", done.stderr)
        assert told, done.stderr
        if told[1] is not None:
            return ("refused", "gate", told[3], told[2])
        return (None, None, told[3], told[2])

    def _words(self, body: Json) -> list[str]:
        match body["type"]:
            case "takeOff":
                return ["takeoff", str(body["altitude"]), "--no-wait"]
            case "goTo":
                return ["goto", *(str(body[n]) for n in ("latitude", "longitude", "altitude")), "--no-wait"]
            case "uploadMission":
                file = self._folder / "mission.json"
                file.write_text(json.dumps({"items": body["items"]}))
                return ["mission", "upload", str(file)]
            case "startMission":
                return ["mission", "start", "--no-wait"]
            case "returnToLaunch":
                return ["rtl", "--no-wait"]
        return [str(body["type"])]

    def _run(self, *words: str) -> "subprocess.CompletedProcess[str]":
        return subprocess.run(
            [sys.executable, "-m", "dronectl", *words],
            env=self._environment,
            cwd=self._folder,
            text=True,
            capture_output=True,
            timeout=90,
        )

    def close(self) -> None:
        return None


def _environment(server: Server, key: str) -> dict[str, str]:

    return os.environ | {"DRONEMAP_URL": server.address, "DRONEMAP_KEY": key}
