"""Who sends a drone somewhere learns when it is there, or why it will not be."""

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import pytest

from dronemap import Interrupted, models
from dronemap.arrival import arrived, at_height, at_place, mission_flown, on_ground
from dronemap.geo import meters_between
from dronemap.testing import MockTransport

PLACE = {"latitude": 47.4, "longitude": 8.5, "altitudeAmsl": 500.0, "altitudeAboveHome": 20.0}


def state(seconds: float = 0, **members: Any) -> models.DroneView:
    mock = MockTransport()
    id = mock.add_drone("alpha", **{"flight": "inAir", "position": PLACE} | members)
    made = models.DroneView.model_validate(mock._drones[id])
    return made.model_copy(update={"last_update": made.last_update.replace(second=int(seconds))})


async def _each(states: list[models.DroneView]) -> AsyncIterator[models.DroneView]:
    for one in states:
        yield one


def test_heights_and_places_are_measured_by_their_reference() -> None:
    assert at_height(20)(state())
    assert not at_height(25)(state())
    assert at_place(47.4, 8.5, 20, "home")(state())
    assert at_place(47.4, 8.5, 500, "amsl")(state())
    assert not at_place(47.4, 8.5, 500, "home")(state())
    assert not at_place(47.4001, 8.5, 20, "home")(state())
    assert not at_place(47.4, 8.5, 20, "home")(state(position=None))


def test_great_circle() -> None:
    assert meters_between(47, 8, 48, 8) == pytest.approx(111_195, rel=1e-4)
    assert meters_between(0, 179.5, 0, -179.5) == pytest.approx(111_195, rel=1e-4)
    assert meters_between(89, 0, 89, 180) == pytest.approx(222_390, rel=1e-4)


def _aim(*states: models.DroneView) -> models.DroneView:
    return asyncio.run(arrived(_each(list(states)), at_height(30), "30 m above home"))


def test_first_state_that_is_there_ends_the_wait() -> None:
    there = state(position=PLACE | {"altitudeAboveHome": 30.0})
    assert _aim(state(), state(), there) is there


def test_change_of_control_ends_the_wait() -> None:
    taken = {"state": "held", "holder": "bea", "epoch": 5, "explicit": True, "requests": []}
    with pytest.raises(Interrupted, match=r"alpha is not 30 m above home: control of it has changed \(bea has it\)"):
        _aim(state(), state(control=taken))


def test_change_of_mode_ends_the_wait_once_the_command_has_settled() -> None:
    with pytest.raises(Interrupted, match="from GUIDED to LOITER"):
        _aim(state(0), state(1), state(5, mode="LOITER"))
    there = state(6, position=PLACE | {"altitudeAboveHome": 30.0}, mode="AUTO")
    assert _aim(state(0, mode="RTL"), state(1, mode="AUTO"), state(5, mode="AUTO"), there) is there


def test_drone_that_comes_down_does_not_arrive() -> None:
    with pytest.raises(Interrupted, match="on the ground"):
        _aim(state(), state(flight="onGround", armed=False))


def test_mission_is_flown_when_its_drone_lands_a_while_before_it_says_so() -> None:
    flying = {"running": True, "reached": [], "state": "running"}
    landed = state(1, flight="onGround", armed=True, mission=flying)
    over = state(2, flight="onGround", armed=False, mission=flying)
    states = _each([state(mission=flying), landed, over])
    assert asyncio.run(arrived(states, mission_flown(), "at the end of its mission")) is over


def test_end_of_a_mission_is_one_that_was_begun() -> None:
    over = mission_flown()
    complete = {"running": False, "reached": [], "state": "complete"}
    assert not over(state(flight="onGround", armed=False, mission=complete))
    assert not over(state(mission={"running": True, "reached": [], "state": "running"}))
    assert over(state(mission=complete))
    over = mission_flown()
    assert not over(state())
    assert over(state(flight="onGround", armed=False))


def test_ground() -> None:
    assert on_ground(state(flight="onGround"))
