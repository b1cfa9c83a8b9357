"""Events come in order and once, over cuts; what is kept no more is a gap."""

from itertools import islice

import pytest

from dronemap import FIRST, Dronemap, EventGap, NumberedEvent, Problem, models
from dronemap.events import in_order
from dronemap.testing import MockTransport


def texts(events: list[NumberedEvent | EventGap]) -> list[str]:
    return [event.text for event in events]


def test_events_from_now_on(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    mock.add_event(id, "before")
    events = server.events()
    mock.add_event(id, "one")
    assert next(events).text == "one"
    mock.add_event(id, "two")
    assert next(events).text == "two"


def test_several_read_the_same(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    first, second = server.events(), server.events()
    for number in range(3):
        mock.add_event(id, f"{number}")
    assert texts(list(islice(first, 3))) == texts(list(islice(second, 3))) == ["0", "1", "2"]


def test_none_is_lost_while_the_server_is_away(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    events = server.events()
    mock.add_event(id, "one")
    assert next(events).text == "one"
    mock.go_away()
    mock.add_event(id, "two")
    mock.come_back()
    mock.lose_answers("GET", 1)
    assert next(events).text == "two"


def test_what_is_kept_no_more_is_a_gap_in_its_place(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    numbers = [mock.add_event(id, f"{number}") for number in range(4)]
    mock.lose_events(numbers[1])
    events = server.events(FIRST)
    gap, *others = islice(events, 3)
    assert isinstance(gap, EventGap)
    assert (gap.cause, gap.after) == ("expired", numbers[1])
    assert texts(others) == ["2", "3"]


def test_another_program_goes_on_from_a_cursor(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    mock.add_event(id, "one")
    events = server.events(FIRST)
    next(events)
    mock.add_event(id, "two")
    next(events)
    mock.add_event(id, "three")
    assert "three" in texts(list(islice(server.events(events.cursor), 2)))


def test_refusal_ends_the_iterator(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    events = server.events()
    mock.answer("GET", "/events", {"status": 401, "code": "signed-out", "detail": "The key is gone."}, 401)
    with pytest.raises(Problem, match="The key is gone"):
        next(events)


def test_gaps_stand_before_what_comes_after_them() -> None:
    def event(number: int) -> NumberedEvent:
        at = "2026-01-01T00:00:00Z"
        return NumberedEvent.model_validate(
            {"number": number, "drone": "d", "at": at, "kind": "mode", "text": f"{number}"}
        )

    gap = EventGap.model_validate({"after": 2, "cause": "serverEnded", "text": "gap"})
    page = models.FollowedEvents(events=[event(1), event(2), event(3)], gaps=[gap], next="c")
    assert texts(in_order(page)) == ["1", "2", "gap", "3"]
