"""dronectl send, dispatch: drones of the pool that are sent to a place."""

import asyncio

import click

from dronectl.command import Group, NumbersCommand, connected
from dronectl.failure import NotDone
from dronectl.flight import NO_WAIT
from dronectl.output import Working, table
from dronectl.reading import fitted
from dronectl.settings import Session
from dronemap import DronemapError, NotHere
from dronemap.contract.models import DispatchRequest, DispatchView
from dronemap.dispatch import AsyncDispatch

_OVER = ("returning", "over")


@click.command(cls=NumbersCommand)
@click.argument("latitude", type=float)
@click.argument("longitude", type=float)
@click.option("--height", type=float, help="Metres above the drone's home, 5 to 120; else 30.")
@click.option("--minutes", type=float, help="How long it shall be able to stay, 1 to 60; else 5.")
@click.option("--stay", type=click.FloatRange(0, 3600), help="Seconds to keep it there; then it is called home.")
@NO_WAIT
@connected
async def send(
    session: Session,
    latitude: float,
    longitude: float,
    height: float | None,
    minutes: float | None,
    stay: float | None,
    no_wait: bool,
) -> None:
    """Send the best free drone of the pool to a place, and keep it there.

    When it is there, control of it is yours. It is kept until Ctrl-C or for --stay seconds; then the drone flies
    home. Ctrl-C before that calls the drone off. With --no-wait nobody keeps it: take control within 20 s.
    """
    members = {"latitude": latitude, "longitude": longitude, "height": height, "minutes": minutes}
    asked = {name: value for name, value in members.items() if value is not None}
    view = await session.server.rest.send_drone(fitted("The drone", asked, DispatchRequest))
    if no_wait:
        session.output.show(view, _sentence(view))
        return
    sent = AsyncDispatch(view, session.server.rest, session.server.stream)
    try:
        with session.output.working("A drone") as working:
            await _kept(session, sent, stay, working)
    except (asyncio.CancelledError, DronemapError):
        await _called_off(session, sent)
        raise
    ended = await sent.wait()
    session.output.show(ended, _sentence(ended))


async def _kept(session: Session, sent: AsyncDispatch, stay: float | None, working: Working) -> None:
    told = ""
    async for now in sent.progress():
        if _sentence(now) != told:
            told = _sentence(now)
            session.output.note(told)
        working.say(f"{now.drone_name or 'a drone'}: {now.state}")
    try:
        drone = await session.server.drone(await sent.arrival())
    except NotHere as e:
        raise NotDone(str(e)) from e
    async with drone.control(on_exit="keep"):
        working.say(f"{drone.name} is here")
        await asyncio.sleep(stay if stay is not None else float("inf"))
    await sent.cancel()


async def _called_off(session: Session, sent: AsyncDispatch) -> None:
    try:
        if (await session.server.rest.get_dispatch(sent.id)).state not in _OVER:
            view = await sent.cancel()
            session.output.note(_sentence(view))
    except DronemapError as e:
        session.output.note(f"It could not be called off: {e} The drone flies home since nobody has control of it.")


@click.group(cls=Group)
def dispatch() -> None:
    """Drones that were sent to a place (see: dronectl send)."""


@dispatch.command("list")
@connected
async def list_dispatches(session: Session) -> None:
    """List the drones that were sent."""
    answer = await session.server.rest.list_dispatches()
    rows = [(view.id, view.drone_name, view.state, view.owner, view.end or view.note) for view in answer.dispatches]
    session.output.show(answer, table(("ID", "DRONE", "STATE", "OWNER", "NOTE"), rows))


@dispatch.command()
@click.argument("id")
@connected
async def cancel(session: Session, id: str) -> None:
    """Call one off: its drone flies home, from wherever it is."""
    view = await session.server.rest.cancel_dispatch(id)
    session.output.show(view, _sentence(view))


def _sentence(view: DispatchView) -> str:
    said = view.end or view.note or (view.told[-1].words if view.told else "")
    return f"{view.drone_name or 'No drone'} ({view.id}): {view.state}. {said}".strip()
