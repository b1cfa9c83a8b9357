"""Each command ends in one of six ways, and acts once however often it is sent."""

import pytest

from dronemap import (
    CommandError,
    Dronemap,
    Failed,
    OutcomeUnknown,
    Refused,
    Succeeded,
    Superseded,
    TimedOut,
    WaitedTooLong,
    models,
)
from dronemap.testing import MockTransport

ENDS: dict[str, type[CommandError]] = {
    "refused": Refused,
    "failed": Failed,
    "timedOut": TimedOut,
    "superseded": Superseded,
    "unknown": OutcomeUnknown,
}


@pytest.mark.parametrize("result", ENDS)
def test_each_way_to_end_is_a_type(server: Dronemap, mock: MockTransport, result: str) -> None:
    mock.add_drone("alpha")
    mock.end_commands_as(result, "So it was.", by="vehicle")
    with pytest.raises(ENDS[result], match="So it was.") as raised:
        server.drone("alpha").arm()
    assert raised.value.by == "vehicle"
    assert isinstance(server.drone("alpha").give(models.ArmCommand()).outcome(5), ENDS[result])


def test_command_that_succeeds_tells_its_warnings(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    outcome = server.drone().give(models.ArmCommand()).wait(5)
    assert isinstance(outcome, Succeeded)
    assert [command["type"] for command in mock.commands] == ["arm"]


def test_refusal_by_the_server_is_an_outcome(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    mock.refuse("takeOff", "drone-airborne", "It is already in the air.")
    with pytest.raises(Refused) as raised:
        server.drone().take_off(10)
    assert (raised.value.by, raised.value.code) == ("gate", "drone-airborne")
    assert "It is already in the air." in str(raised.value)


def test_speed_is_changed_by_its_number_and_refused_with_the_range(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    server.drone().change_speed(5)
    assert mock.commands[-1]["type"] == "changeSpeed"
    assert mock.commands[-1]["metersPerSecond"] == 5
    sentence = "metersPerSecond must be 0.2 to 30 for a vehicle of this kind (multicopter), not 40."
    mock.refuse("changeSpeed", "speed-not-possible", sentence)
    with pytest.raises(Refused, match="0.2 to 30") as raised:
        server.drone().change_speed(40)
    assert raised.value.code == "speed-not-possible"


def test_command_whose_answer_is_lost_acts_once(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    mock.lose_answers("POST", 2)
    server.drone().arm()
    assert len(mock.commands) == 1
    assert sum(method == "POST" for method, _, _ in mock.requests) == 3


def test_command_of_which_nobody_knows_anything_is_unknown(mock: MockTransport) -> None:
    with Dronemap.connect(transport=mock, patience=0.3) as server:
        mock.add_drone("alpha")
        drone = server.drone()
        mock.lose_answers("POST", 100)
        mock.lose_answers("GET", 100)
        with pytest.raises(OutcomeUnknown):
            drone.arm()


def test_outcome_is_asked_for_where_the_stream_was_cut(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    drone = server.drone()
    drone.wait_for(lambda state: True, 5)
    mock.cut()
    assert isinstance(drone.give(models.ArmCommand()).outcome(10), Succeeded)


def test_command_that_takes_too_long_is_still_under_way(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    under_way = {
        **{"id": "c1", "drone": id, "type": "arm", "summary": "Arm", "by": "me", "face": "rest"},
        **{"at": "2026-01-01T00:00:00Z", "phase": "sent", "warnings": []},
    }
    mock.answer("POST", f"/drones/{id}/commands", under_way, 202)
    mock.answer("GET", "/commands/c1", under_way)
    command = server.drone().give(models.ArmCommand())
    with pytest.raises(WaitedTooLong, match="still under way"):
        command.outcome(0.2)
    mock.answer("GET", "/commands/c1", under_way | {"outcome": {"result": "succeeded"}, "phase": "done"})
    assert isinstance(command.outcome(10), Succeeded)


def test_mode_is_changed_first_where_the_vehicle_wants_another(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha", mode="RTL", actions={"arm": {"allowed": True, "why": None, "mode": "GUIDED"}})
    server.drone().arm()
    assert [(c["type"], c.get("mode")) for c in mock.commands] == [("setMode", "GUIDED"), ("arm", None)]


def test_unknown_drone_is_named_among_those_that_there_are(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    with pytest.raises(Exception, match="no drone 'beta'; there are: alpha"):
        server.drone("beta")
