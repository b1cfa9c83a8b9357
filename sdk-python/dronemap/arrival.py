"""Waiting until a drone is where it was sent."""

import math
from collections.abc import AsyncIterator, Callable
from datetime import timedelta

from dronemap.contract.models import DroneView
from dronemap.errors import DronemapError

_EARTH_METERS = 6_371_000.0
#: Vehicles stop within this of a place.
_NEAR_METERS = 2.0
_NEAR_HEIGHT_METERS = 1.0
#: The mode that belongs to a command may be told a little after it was accepted.
_SETTLES = timedelta(seconds=2)


class Interrupted(DronemapError):
    """The drone was kept from where it was sent: somebody else acted, or it came down."""


def at_height(meters: float) -> Callable[[DroneView], bool]:
    """Whether it is at least so many metres above home."""

    def reached(state: DroneView) -> bool:
        height = None if state.position is None else state.position.altitude_above_home
        return height is not None and height >= meters - max(0.5, 0.05 * meters)

    return reached


def at_place(latitude: float, longitude: float, altitude: float, reference: str | None) -> Callable[[DroneView], bool]:
    """Whether it is at that place: degrees, metres above home or above mean sea level (amsl)."""

    def reached(state: DroneView) -> bool:
        place = state.position
        if place is None or place.latitude is None or place.longitude is None:
            return False
        height = place.altitude_amsl if reference == "amsl" else place.altitude_above_home
        return (
            height is not None
            and abs(height - altitude) <= _NEAR_HEIGHT_METERS
            and meters_between(place.latitude, place.longitude, latitude, longitude) <= _NEAR_METERS
        )

    return reached


def on_ground(state: DroneView) -> bool:
    return state.flight == "onGround"


def mission_over(state: DroneView) -> bool:
    """Whether the vehicle says that it is at the end of its mission, which may be one before, or is down."""
    return state.mission.state == "complete" or (state.flight == "onGround" and not state.armed)


def mission_flown() -> Callable[[DroneView], bool]:
    """Whether the vehicle is at the end of its mission, or down again, after it was seen to fly it."""
    begun = False

    def over(state: DroneView) -> bool:
        nonlocal begun
        begun = begun or state.mission.running or state.flight in ("takingOff", "inAir")
        return begun and mission_over(state)

    return over


async def arrived(states: AsyncIterator[DroneView], reached: Callable[[DroneView], bool], aim: str) -> DroneView:
    """The first state that is there; `Interrupted` when it cannot come to that any more."""
    first: DroneView | None = None
    was_up = False
    async for state in states:
        if reached(state):
            return state
        if first is None or state.last_update - first.last_update < _SETTLES:
            mode = state.mode
        first = first or state
        was_up = was_up or state.flight == "inAir"
        if state.control.epoch != first.control.epoch:
            raise Interrupted(f"{state.name} is not {aim}: control of it has changed ({_holder(state)}).")
        if state.mode != mode:
            raise Interrupted(f"{state.name} is not {aim}: its mode was changed from {mode} to {state.mode}.")
        if was_up and state.flight == "onGround":
            raise Interrupted(f"{state.name} is not {aim}: it is on the ground.")
    raise Interrupted("The connection was closed meanwhile.")


def meters_between(latitude: float, longitude: float, to_latitude: float, to_longitude: float) -> float:
    """Over ground, along a great circle."""
    a, b = math.radians(latitude), math.radians(to_latitude)
    half_up = math.sin((b - a) / 2) ** 2
    half_along = math.sin(math.radians(to_longitude - longitude) / 2) ** 2
    return 2 * _EARTH_METERS * math.asin(math.sqrt(min(1.0, half_up + math.cos(a) * math.cos(b) * half_along)))


def _holder(state: DroneView) -> str:
    if state.control.state == "pilot":
        return "the pilot at the vehicle has it"
    return f"{state.control.holder} has it" if state.control.holder else "nobody has it"
