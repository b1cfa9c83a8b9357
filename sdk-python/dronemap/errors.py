"""What goes wrong, as errors whose text is a sentence for people."""

from collections.abc import Mapping
from datetime import datetime
from typing import Any


class DronemapError(Exception):
    """Anything that this client reports; its text says what happened and what to do."""


class NotConfigured(DronemapError):
    """Nothing says which server to ask, or with which key."""


class Unreachable(DronemapError):
    """The server did not answer; what was asked was not carried out."""


class AnswerLost(DronemapError):
    """The connection ended after the request was sent: whether it was carried out is not known."""


class ServerLacks(DronemapError):
    """The server is older or newer than this client, and lacks what was asked for."""


class WaitedTooLong(DronemapError):
    """A condition did not come true in the time that was given for it."""


class ControlLost(DronemapError):
    """Control of the drone has ended while it was needed."""


class Problem(DronemapError):
    """A request that the server refused, with its reason.

    `code` tells programs why exactly (docs/problems.md lists them), `parameters` what the sentence is about; `field`
    and `allowed` name what was wrong in a request; `holder` has control of the drone.
    """

    def __init__(self, status: int, members: Mapping[str, Any]) -> None:
        detail = members.get("detail")
        super().__init__(detail or f"The server answered with status {status}.")
        self.status = status
        self.code: str | None = members.get("code")
        self.parameters: Mapping[str, str | float | bool] = members.get("parameters") or {}
        self.field: str | None = members.get("field")
        self.allowed: str | None = members.get("allowed")
        self.holder: str | None = members.get("holder")
        self.held_since = _time(members.get("heldSince"))
        self.command_id: str | None = members.get("commandId")
        self.retry_after_seconds: float | None = members.get("retryAfterSeconds")


def _time(text: str | None) -> datetime | None:
    return None if text is None else datetime.fromisoformat(text)
