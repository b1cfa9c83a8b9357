"""Calls are sent again where that acts once, and only there."""

import asyncio
import json
from collections.abc import Mapping
from typing import Any

import pytest

from dronemap import AnswerLost, Problem, ServerLacks, Unreachable, models
from dronemap.contract.operations import Operations
from dronemap.sender import Sender
from dronemap.transport import HttpAnswer

ZONES = json.dumps({"type": "FeatureCollection", "features": []}).encode()
Played = HttpAnswer | Exception


class Scripted:
    """Plays one answer after the other."""

    def __init__(self, *played: Played) -> None:
        self.played = list(played)
        self.asked = 0

    async def request(self, method: str, path: str, *, query: Mapping[str, str], **_: Any) -> HttpAnswer:
        self.asked += 1
        answer = self.played.pop(0)
        if isinstance(answer, Exception):
            raise answer
        return answer

    def stream(self, port: int) -> Any:
        raise AssertionError("REST alone")

    async def close(self) -> None:
        return None


def problem(status: int, **members: Any) -> HttpAnswer:
    return HttpAnswer(status, {"dronemap-version": "7.1"}, json.dumps({"status": status} | members).encode())


def zones(*played: Played, patience: float = 5) -> tuple[Any, Scripted]:
    transport = Scripted(*played)
    return asyncio.run(Operations(Sender(transport, patience)).list_zones()), transport


def test_what_was_not_sent_is_sent_again_whatever_it_is() -> None:
    transport = Scripted(Unreachable("away"), Unreachable("away"), HttpAnswer(204, {}, b""))
    asyncio.run(Operations(Sender(transport, 5)).sign_out_user("ann"))
    assert transport.asked == 3


def test_lost_answer_of_a_read_is_asked_for_again() -> None:
    _, transport = zones(AnswerLost("lost"), HttpAnswer(200, {}, ZONES))
    assert transport.asked == 2


def test_lost_answer_of_what_acts_twice_is_told() -> None:
    transport = Scripted(AnswerLost("not known"))
    with pytest.raises(AnswerLost, match="not known"):
        asyncio.run(Operations(Sender(transport, 5)).add_group(models.GroupRequest(name="x")))
    assert transport.asked == 1


def test_removal_whose_answer_was_lost_has_happened_when_nothing_is_there_any_more() -> None:
    transport = Scripted(AnswerLost("lost"), problem(404, code="zone-unknown", detail="There is no such zone."))
    asyncio.run(Operations(Sender(transport, 5)).delete_zone("z"))
    assert transport.asked == 2


def test_removal_of_what_was_never_there_is_refused() -> None:
    with pytest.raises(Problem, match="no such zone"):
        gone = problem(404, code="zone-unknown", detail="There is no such zone.")
        asyncio.run(Operations(Sender(Scripted(gone), 5)).delete_zone("z"))


def test_throttled_call_is_sent_again_after_the_time_that_the_server_names() -> None:
    wait = problem(429, code="too-many", detail="Wait 1 s.", retryAfterSeconds=0.4)
    begun = asyncio.new_event_loop()
    before = begun.time()
    _, transport = zones(wait, HttpAnswer(200, {}, ZONES))
    assert transport.asked == 2
    assert begun.time() - before >= 0.3


def test_patience_ends() -> None:
    transport = Scripted(*[Unreachable("away")] * 100)
    with pytest.raises(Unreachable):
        asyncio.run(Operations(Sender(transport, 0.5)).list_zones())
    assert transport.asked < 5


def test_refusal_tells_all_that_the_server_said() -> None:
    refused = problem(
        409,
        code="control-held",
        detail="Bea has control.",
        holder="bea",
        heldSince="2026-01-01T00:00:00Z",
        parameters={"user": "bea"},
        field="epoch",
        allowed="the newest",
    )
    with pytest.raises(Problem) as raised:
        zones(refused)
    error = raised.value
    assert str(error) == "Bea has control."
    assert (error.status, error.code, error.holder, error.field) == (409, "control-held", "bea", "epoch")
    assert error.held_since is not None and error.held_since.year == 2026
    assert error.parameters == {"user": "bea"}


def test_page_of_something_in_between_is_no_reason_to_fall_over() -> None:
    with pytest.raises(Problem, match="status 404"):
        zones(HttpAnswer(404, {}, b"<html>not here</html>"))


def test_operation_that_an_older_server_lacks_is_named_with_both_versions() -> None:
    with pytest.raises(ServerLacks, match=r"version 7\.1\) has no listZones; this client is of version 0\.1\.0"):
        zones(problem(404, code="address-unknown", detail="There is nothing at this address."))


def test_answer_that_cannot_be_read_names_the_member() -> None:
    with pytest.raises(ServerLacks, match=r"listDrones .* drones\.0\.actions"):
        transport = Scripted(HttpAnswer(200, {}, json.dumps({"drones": [{"id": "x"}]}).encode()))
        asyncio.run(Operations(Sender(transport, 1)).list_drones())
