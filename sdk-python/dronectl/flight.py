"""dronectl arm, takeoff, goto and so on: one drone, one command."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from typing import Literal

import click

from dronectl.command import Command, NumbersCommand, connected, drone_option
from dronectl.failure import NotSeen
from dronectl.output import Working
from dronectl.settings import Session
from dronemap import DronemapError
from dronemap.arrival import arrived, at_height, at_place, on_ground
from dronemap.command import AsyncCommand
from dronemap.command import Command as DroneCommand
from dronemap.contract.models import (
    ArmCommand,
    ChangeSpeedCommand,
    CommandView,
    DisarmCommand,
    DroneView,
    GoToCommand,
    HoldCommand,
    ReturnToLaunchCommand,
    SetModeCommand,
    TakeOffCommand,
)
from dronemap.drone import AsyncDrone
from dronemap.geo import meters_between

#: What becomes of the drone when its user presses Ctrl-C on the way.
WhenInterrupted = Literal["hold", "goOn"]
NO_WAIT = click.option("--no-wait", is_flag=True, help="End as soon as the vehicle has accepted it.")
_LOOK_SECONDS = 1.0
_CHANGES = frozenset({"command"})


@click.command(cls=Command)
@drone_option
@connected
async def arm(session: Session, drone: str | None) -> None:
    """Start the motors."""
    await told(session, await session.drone(drone), ArmCommand())


@click.command(cls=Command)
@drone_option
@connected
async def disarm(session: Session, drone: str | None) -> None:
    """Stop the motors on the ground."""
    await told(session, await session.drone(drone), DisarmCommand())


@click.command(cls=Command)
@click.argument("mode")
@drone_option
@connected
async def mode(session: Session, mode: str, drone: str | None) -> None:
    """Change the flight mode, by the vehicle's own name of it."""
    await told(session, await session.drone(drone), SetModeCommand(mode=mode))


@click.command(cls=Command)
@click.argument("altitude", type=float)
@NO_WAIT
@drone_option
@connected
async def takeoff(session: Session, altitude: float, no_wait: bool, drone: str | None) -> None:
    """Climb to ALTITUDE metres above home.

    The motors have to run (dronectl arm). Ctrl-C on the way: the drone holds.
    """
    flown = await session.drone(drone)
    reached = None if no_wait else at_height(altitude)
    await flies(session, flown, TakeOffCommand(altitude=altitude), reached, f"{altitude:g} m above home", "hold")


@click.command(cls=NumbersCommand)
@click.argument("latitude", type=float)
@click.argument("longitude", type=float)
@click.argument("altitude", type=float)
@click.option("--amsl", is_flag=True, help="ALTITUDE is above mean sea level, not above home.")
@NO_WAIT
@drone_option
@connected
async def goto(
    session: Session,
    latitude: float,
    longitude: float,
    altitude: float,
    amsl: bool,
    no_wait: bool,
    drone: str | None,
) -> None:
    """Fly to a place: degrees, and metres above home.

    Ctrl-C on the way: the drone holds.
    """
    reference: Literal["amsl"] | None = "amsl" if amsl else None
    command = GoToCommand(latitude=latitude, longitude=longitude, altitude=altitude, altitude_reference=reference)
    reached = None if no_wait else at_place(latitude, longitude, altitude, reference)
    flown = await session.drone(drone)
    aim = f"at {latitude:g}, {longitude:g}"

    def far(state: DroneView) -> str:
        place = state.position
        if place is None or place.latitude is None or place.longitude is None:
            return ""
        return f", {meters_between(place.latitude, place.longitude, latitude, longitude):.0f} m to go"

    await flies(session, flown, command, reached, aim, "hold", far)


@click.command(cls=Command)
@NO_WAIT
@drone_option
@connected
async def rtl(session: Session, no_wait: bool, drone: str | None) -> None:
    """Fly home and land there.

    Ctrl-C on the way: it goes on home.
    """
    reached = None if no_wait else on_ground
    await flies(session, await session.drone(drone), ReturnToLaunchCommand(), reached, "at home", "goOn")


@click.command(cls=Command)
@drone_option
@connected
async def hold(session: Session, drone: str | None) -> None:
    """Stop and stay where it is."""
    await told(session, await session.drone(drone), HoldCommand())


@click.command(cls=Command)
@click.argument("meters_per_second", type=float)
@drone_option
@connected
async def speed(session: Session, meters_per_second: float, drone: str | None) -> None:
    """Go on at another speed, in m/s, until the mode changes."""
    await told(session, await session.drone(drone), ChangeSpeedCommand(meters_per_second=meters_per_second))


async def told(session: Session, drone: AsyncDrone, command: DroneCommand) -> CommandView:
    """Carries out a command that is over when the vehicle has done it, and prints it."""
    with session.output.working(f"{drone.name}: {command.type}") as working:
        view = await carried_out(session, drone, command, working)
    session.output.show(view, f"{drone.name}: {view.summary}: done.")
    return view


async def flies(
    session: Session,
    drone: AsyncDrone,
    command: DroneCommand,
    reached: Callable[[DroneView], bool] | None,
    aim: str,
    when_interrupted: WhenInterrupted,
    further: Callable[[DroneView], str] = lambda state: "",
) -> None:
    """Carries out a command, and waits until the drone is where it leads; without `reached`, it does not wait."""
    async with Interruptible(session, drone, when_interrupted):
        with session.output.working(f"{drone.name}: {command.type}") as working:
            view = await carried_out(session, drone, command, working)
            if reached is not None:
                await seen(session, drone, reached, aim, working, further)
    session.output.show(view, f"{drone.name} is {aim}." if reached else f"{drone.name}: {view.summary}: accepted.")


async def carried_out(session: Session, drone: AsyncDrone, command: DroneCommand, working: Working) -> CommandView:
    """The command when the vehicle has done it; raises a `CommandError` when it has not."""
    action = drone.state.actions.get(command.type)
    if action is not None and action.mode is not None:
        # The vehicle takes it in another mode only, such as arming after a return.
        await (await drone.give(SetModeCommand(mode=action.mode))).wait()
    return await finished(session, await drone.give(command), working)


async def finished(session: Session, given: AsyncCommand, working: Working) -> CommandView:
    """The command when it was carried out; meanwhile the line tells how far it is."""
    for warning in given.view.warnings:
        session.output.note(f"Warning: {warning}")
    watching = asyncio.ensure_future(_progress(session, given.id, given.view.summary, working))
    try:
        await given.wait()
    finally:
        watching.cancel()
    return given.view


async def conducted(session: Session, ask: Callable[[], Awaitable[CommandView]], working: Working) -> CommandView:
    """The same for a command that an operation of its own begins, such as the fetching of a log."""
    await session.ready()
    # From now on: the outcome may be told before the answer has come.
    told = session.server.stream.messages(_CHANGES, None)
    return await finished(session, AsyncCommand(await ask(), session.server.rest, told), working)


async def seen(
    session: Session,
    drone: AsyncDrone,
    reached: Callable[[DroneView], bool],
    aim: str,
    working: Working,
    further: Callable[[DroneView], str] = lambda state: "",
) -> None:
    """Returns when the drone is there, and tells on the way how it is."""
    if not session.server.stream.connected:
        raise NotSeen(f"{drone.name} was told, and does it; whether it arrives cannot be seen.")
    states = drone.states()
    looking = asyncio.ensure_future(_connection(session, drone, working))
    try:
        await arrived(_told_of(states, working, further), reached, aim)
    finally:
        looking.cancel()
        await states.aclose()


class Interruptible:
    """Around what makes a drone fly: says what becomes of it when the user ends dronectl on the way."""

    def __init__(self, session: Session, drone: AsyncDrone, when_interrupted: WhenInterrupted) -> None:
        self._session = session
        self._drone = drone
        self._hold = when_interrupted == "hold"

    async def __aenter__(self) -> None:
        return None

    async def __aexit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is None or not issubclass(kind, asyncio.CancelledError) or not self._session.interrupted:
            return
        name, note = self._drone.name, self._session.output.note
        if not self._hold:
            note(f"Interrupted: {name} goes on. To stop it: dronectl hold --drone {self._drone.id}")
            return
        try:
            await self._drone.hold()
        except DronemapError as e:
            note(f"Interrupted, and {name} could not be told to hold: it may fly on. {e}")
        else:
            note(f"Interrupted: {name} holds where it is. Next: dronectl land or rtl --drone {self._drone.id}")


async def _told_of(
    states: AsyncIterator[DroneView], working: Working, further: Callable[[DroneView], str]
) -> AsyncIterator[DroneView]:
    async for state in states:
        height = None if state.position is None else state.position.altitude_above_home
        working.say(f"{state.name}: {state.mode}{'' if height is None else f', {height:.1f} m'}{further(state)}")
        yield state


async def _connection(session: Session, drone: AsyncDrone, working: Working) -> None:
    """Says when nothing is heard of it: what stands there would be old."""
    while True:
        await asyncio.sleep(_LOOK_SECONDS)
        if not session.server.stream.connected:
            working.say(f"{drone.name}: the connection to the server is interrupted")


async def _progress(session: Session, command: str, summary: str, working: Working) -> None:
    with session.server.stream.messages(_CHANGES, None) as changes:
        async for message in changes:
            view = message["command"]
            progress = view.get("progress")
            if view["id"] == command and progress is not None:
                working.say(summary, progress["done"], progress["total"])
