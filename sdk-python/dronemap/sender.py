"""Sends calls, again where that acts once, and reads what is answered."""

import asyncio
import json
import random
from collections.abc import Callable, Mapping
from typing import Any, cast

from pydantic import TypeAdapter, ValidationError

from dronemap.contract.call import Answer, Call
from dronemap.errors import AnswerLost, DronemapError, Problem, ServerLacks, Unreachable
from dronemap.transport import HttpAnswer, Transport
from dronemap.version import VERSION

_FIRST_PAUSE = 0.2
_LONGEST_PAUSE = 5.0
_THROTTLED = 429
_AWAY = 503
_GATEWAYS = (502, 504)
_NO_SUCH_PLACE = ("address-unknown", "method-not-taken")


class Sender:
    """Sends calls to one server, and tries again for `patience` seconds while that cannot act twice.

    What was not sent, and what the server refused for now (429, 503), is sent again; what may have been carried out
    only where carrying it out twice is the same as once.
    """

    def __init__(self, transport: Transport, patience: float, clock: Callable[[], float] | None = None) -> None:
        self._transport = transport
        self._patience = patience
        self._clock = clock or (lambda: asyncio.get_running_loop().time())
        self.server_version: str | None = None

    async def send(self, call: Call, answer: type[Answer] | None) -> Answer:
        response = await self._answered(call)
        if answer is None:
            return cast(Answer, None)
        if answer is bytes:
            return cast(Answer, response.content)
        if answer is str:
            return cast(Answer, response.headers.get("location", ""))
        return self._read(call, response, answer)

    async def _answered(self, call: Call) -> HttpAnswer:
        query, content = _query(call.query), call.content()
        until = self._clock() + self._patience
        pause = _FIRST_PAUSE
        unclear = False
        while True:
            try:
                response = await self._transport.request(
                    call.method, call.path, query=query, content=content, content_type=call.content_type
                )
            except Unreachable as e:
                failure: DronemapError = e
            except AnswerLost as e:
                failure, unclear = e, True
                if not call.acts_once:
                    raise
            else:
                self.server_version = response.headers.get("dronemap-version", self.server_version)
                if response.status < 400:
                    return response
                if unclear and response.status == 404 and call.method == "DELETE":
                    # The try before has removed it.
                    return response
                failure = self._refusal(call, response)
                if not _for_now(response.status, call):
                    raise failure
                pause = max(pause, getattr(failure, "retry_after_seconds", None) or 0)
            wait = pause * random.uniform(0.8, 1.2)
            if self._clock() + wait > until:
                raise failure
            await asyncio.sleep(wait)
            pause = min(_LONGEST_PAUSE, 2 * pause)

    def _refusal(self, call: Call, response: HttpAnswer) -> DronemapError:
        try:
            members: Any = json.loads(response.content)
        except ValueError:
            members = {}
        # What stands in between may answer with a page instead of a problem.
        problem = Problem(response.status, members if isinstance(members, dict) else {})
        if problem.code in _NO_SUCH_PLACE:
            return ServerLacks(
                f"{self._server()} has no {call.operation}; this client is of version {VERSION}. "
                "Update whichever of the two is older."
            )
        return problem

    def _read(self, call: Call, response: HttpAnswer, answer: type[Answer]) -> Answer:
        try:
            return TypeAdapter(answer).validate_json(response.content)
        except ValidationError as e:
            first = e.errors()[0]
            where = ".".join(str(part) for part in first["loc"]) or "the answer"
            raise ServerLacks(
                f"{self._server()} answers {call.operation} in a way that this client (version {VERSION}) cannot "
                f"read: {where}: {first['msg']}. Update whichever of the two is older."
            ) from e

    def _server(self) -> str:
        return f"The server (version {self.server_version})" if self.server_version else "The server"


def _for_now(status: int, call: Call) -> bool:
    return status in (_THROTTLED, _AWAY) or (status in _GATEWAYS and call.acts_once)


def _query(query: Mapping[str, Any]) -> dict[str, str]:
    return {name: _text(value) for name, value in query.items() if value is not None}


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ",".join(_text(part) for part in value)
    return str(value)
