"""dronectl return, land --all, recovery: several drones that come home, or land, together."""

import asyncio
from typing import Literal

import click

from dronectl.command import Command, Group, agreed, connected, drone_option, yes_option
from dronectl.failure import NotDone
from dronectl.flight import NO_WAIT, flies
from dronectl.output import table
from dronectl.reading import fitted
from dronectl.settings import Session
from dronemap import DronemapError
from dronemap.arrival import on_ground
from dronemap.contract.models import LandCommand, RecoveryPreview, RecoveryRequest, RecoveryView
from dronemap.recovery import AsyncRecovery

Manner = Literal["return", "land"]


@click.command("return", cls=Command)
@click.argument("drones", nargs=-1, metavar="[DRONES]...")
@click.option("--all", "everything", is_flag=True, help="All drones in the air that you may command.")
@click.option("--ceiling", type=float, help="Metres above home that none flies home above, 5 to 500; else 120.")
@click.option("--lowest", type=float, help="Metres above home that none flies home below, 5 to 500; else 20.")
@click.option("--take-over", is_flag=True, help="Also those that operations of yours, or a pilot, have.")
@yes_option
@NO_WAIT
@connected
async def return_all(
    session: Session,
    drones: tuple[str, ...],
    everything: bool,
    ceiling: float | None,
    lowest: float | None,
    take_over: bool,
    yes: bool,
    no_wait: bool,
) -> None:
    """Bring several drones home, each at its height and in its turn.

    What will be done is shown and asked for first. Ctrl-C on the way: they go on; dronectl recovery cancel has them
    hold.
    """
    if everything == bool(drones):
        raise click.UsageError("Name drones, or give --all.")
    members = {"ceiling": ceiling, "lowest": lowest, "takeOver": take_over or None}
    await recovers(session, "return", drones, members, yes, no_wait)


@click.command(cls=Command)
@click.option("--all", "everything", is_flag=True, help="All drones in the air that you may command, in turn.")
@yes_option
@NO_WAIT
@drone_option
@connected
async def land(session: Session, everything: bool, yes: bool, no_wait: bool, drone: str | None) -> None:
    """Land where it is.

    With --all, where each comes down is shown and asked for first. Ctrl-C on the way: it goes on landing.
    """
    if everything:
        if drone is not None:
            raise click.UsageError("Name a drone, or give --all.")
        await recovers(session, "land", (), {}, yes, no_wait)
        return
    reached = None if no_wait else on_ground
    await flies(session, await session.drone(drone), LandCommand(), reached, "on the ground", "goOn")


async def recovers(
    session: Session,
    manner: Manner,
    drones: tuple[str, ...],
    members: dict[str, float | bool | None],
    yes: bool,
    no_wait: bool,
) -> None:
    """Shows what would be done and asks, unless `yes`; has it done, and waits until all are down."""
    asked: dict[str, object] = {name: value for name, value in members.items() if value is not None}
    if drones:
        asked["drones"] = [(await session.drone(name)).id for name in drones]
    request = fitted("The recovery", {"manner": manner, **asked}, RecoveryRequest)
    if not yes:
        preview = await session.server.rest.preview_recovery(request)
        session.output.note(_plan(preview))
        agreed(yes, f"{'Land' if manner == 'land' else 'Return'} {len(preview.drones)} drones?")
        request = request.model_copy(update={"previewed": [drone.drone for drone in preview.drones]})
    view = await session.server.rest.begin_recovery(request)
    if not no_wait:
        view = await _watched(session, AsyncRecovery(view, session.server.rest, session.server.stream))
    session.output.show(view, _sentence(view))
    if not no_wait and any(drone.outcome != "down" for drone in view.drones):
        raise NotDone("Not all are down.")


async def _watched(session: Session, recovery: AsyncRecovery) -> RecoveryView:
    told = 0
    try:
        with session.output.working("Drones") as working:
            async for now in recovery.progress():
                for notice in now.told[told:]:
                    session.output.note(notice.words)
                told = len(now.told)
                down = sum(1 for drone in now.drones if drone.outcome == "down")
                working.say(f"{down} of {len(now.drones)} are down")
    except (asyncio.CancelledError, DronemapError):
        session.output.note(f"It goes on: dronectl recovery cancel {recovery.id} has the drones hold.")
        raise
    return recovery.view


def _plan(preview: RecoveryPreview) -> str:
    lines = [f"{len(preview.drones)} drones, about {preview.seconds:.0f} s until all are down:"]
    for drone in preview.drones:
        part = drone.plan
        if part is None:
            lines.append(f"  {drone.drone_name}: not heard; its own fail-safe brings it home")
            continue
        waits = f", after {', '.join(drone.waits_for)}" if drone.waits_for else ""
        lines.append(
            f"  {drone.drone_name}: at {part.height:.0f} m, down at {part.latitude:.6f}, {part.longitude:.6f}"
            f" in about {part.down_seconds:.0f} s{waits}"
        )
    lines += [f"  left out: {one.drone_name}: {one.why}" for one in preview.left_out]
    return "\n".join(lines)


@click.group(cls=Group)
def recovery() -> None:
    """Drones that come home, or land, together (see: dronectl return, dronectl land --all)."""


@recovery.command("list")
@connected
async def list_recoveries(session: Session) -> None:
    """List the recoveries."""
    answer = await session.server.rest.list_recoveries()
    rows = [(view.id, view.manner, view.state, view.owner, len(view.drones), view.end) for view in answer.recoveries]
    session.output.show(answer, table(("ID", "MANNER", "STATE", "OWNER", "DRONES", "END"), rows))


@recovery.command()
@click.argument("id")
@connected
async def cancel(session: Session, id: str) -> None:
    """Call one off: its drones hold, and control of them goes over to whoever asked."""
    view = await session.server.rest.cancel_recovery(id)
    session.output.show(view, _sentence(view))


def _sentence(view: RecoveryView) -> str:
    bad = [f"{drone.drone_name}: {drone.outcome}. {drone.note or ''}".strip() for drone in view.drones if drone.outcome]
    ended = [line for line in bad if ": down." not in line]
    return "\n".join([f"{view.id}: {view.state}. {view.end or ''}".strip(), *ended])
