"""Answers of servers that are older or newer than this client are understood."""

import json
from typing import Any

import pytest
from pydantic import TypeAdapter, ValidationError

from dronemap import Dronemap, models
from dronemap.contract.model import UnknownKind
from dronemap.testing import MockTransport


def test_members_that_a_newer_server_adds_are_left_out(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha", paint="red", battery={"percent": 80, "further": [], "chemistry": "LiPo"})
    state = server.drone("alpha").state
    assert state.battery is not None
    assert state.battery.percent == 80
    assert state.battery.volts is None


def test_values_that_this_client_has_no_name_for_stay_text(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha", flight="diving", kind="ornithopter")
    state = server.drone("alpha").state
    assert (state.flight, state.kind) == ("diving", "ornithopter")


def test_steps_of_a_mission_of_an_unknown_kind_are_kept_as_they_are() -> None:
    steps: Any = [{"type": "dance", "beats": 3}, {"type": "wait", "holdSeconds": 4, "mood": "calm"}]
    mission = {"id": "m", "name": "n", "by": "ann", "changedAt": "2026-01-01T00:00:00Z", "items": steps}
    read = TypeAdapter(models.SavedMissionView).validate_json(json.dumps(mission))
    unknown, wait = read.items
    assert isinstance(unknown, UnknownKind)
    assert unknown.model_dump() == {"type": "dance", "beats": 3}
    assert isinstance(wait, models.WaitItem)
    assert wait.hold_seconds == 4


def test_facts_that_an_older_server_does_not_tell_are_not_known(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    state = server.drone("alpha").state
    assert (state.outlook, state.home, state.firmware) == (None, None, None)


def test_lists_that_an_older_server_does_not_tell_are_empty() -> None:
    battery = models.DroneBatteryView.model_validate({"percent": 80})
    other = models.DroneBatteryView.model_validate({"percent": 70})
    assert battery.further == []
    assert battery.further is not other.further
    told = {"percent": 80, "further": [{"number": 1, "percent": 20}]}
    assert [each.percent for each in models.DroneBatteryView.model_validate(told).further] == [20]


def test_lists_that_this_client_sends_are_still_needed() -> None:
    with pytest.raises(ValidationError):
        models.PolygonGeometry.model_validate({"type": "Polygon"})


def test_outcome_that_this_client_has_no_name_for_is_not_known(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    mock.end_commands_as("postponed", "Later.")
    outcome = server.drone("alpha").give(models.HoldCommand()).outcome(5)
    assert type(outcome).__name__ == "OutcomeUnknown"
    assert "Later." in str(outcome)
