"""Waiting until a drone is where it was sent."""

from collections.abc import AsyncIterator, Callable
from datetime import timedelta

from dronemap.contract.models import DroneView
from dronemap.errors import DronemapError
from dronemap.geo import meters_between

#: Vehicles stop within this of a place.
NEAR_METERS = 2.0
NEAR_HEIGHT_METERS = 1.0
#: Slower than this, m/s, it stands.
_STANDS = 0.5
#: They do not stop in the air.
_CIRCLING = ("fixedWing", "vtol")
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
    """Whether it stands at that place: degrees, metres above home or above mean sea level (amsl).

    There is within 2 m over ground and 1 m in height; what cannot stand in the air need not.
    """

    def reached(state: DroneView) -> bool:
        place = state.position
        if place is None or place.latitude is None or place.longitude is None:
            return False
        height = place.altitude_amsl if reference == "amsl" else place.altitude_above_home
        return (
            height is not None
            and _stands(state)
            and abs(height - altitude) <= NEAR_HEIGHT_METERS
            and meters_between(place.latitude, place.longitude, latitude, longitude) <= NEAR_METERS
        )

    return reached


def _stands(state: DroneView) -> bool:
    speed = None if state.motion is None else state.motion.ground_speed
    return speed is None or speed < _STANDS or state.kind in _CIRCLING


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
        # Motors turn for a moment after a landing, and only then is a mission over.
        if was_up and state.flight == "onGround" and not state.armed:
            raise Interrupted(f"{state.name} is not {aim}: it is on the ground.")
    raise Interrupted("The connection was closed meanwhile.")


def _holder(state: DroneView) -> str:
    if state.control.state == "pilot":
        return "the pilot at the vehicle has it"
    return f"{state.control.holder} has it" if state.control.holder else "nobody has it"
