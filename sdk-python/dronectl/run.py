"""dronectl run: plans that are being flown."""

import asyncio

import click
from rich.table import Table

from dronectl.command import Group, connected
from dronectl.failure import NotDone
from dronectl.output import table
from dronectl.settings import Session
from dronemap.contract.models import RunView
from dronemap.plan import AsyncRun


@click.group(cls=Group)
def run() -> None:
    """Mission runs: plans that are being flown."""


@run.command("list")
@connected
async def list_runs(session: Session) -> None:
    """List the runs."""
    answer = await session.server.rest.list_runs()
    rows = [
        (view.id, view.name, view.state, f"{view.counts.visited}/{view.counts.waypoints}", view.owner, view.began_at)
        for view in answer.runs
    ]
    session.output.show(answer, table(("ID", "NAME", "STATE", "VISITED", "OWNER", "BEGAN"), rows))


@run.command()
@click.argument("id")
@connected
async def show(session: Session, id: str) -> None:
    """Show how a run stands."""
    view = await session.server.rest.get_run(id)
    session.output.show(view, _drones(view))
    if view.proposal is not None and not session.output.as_json:
        session.output.say(f"Proposal {view.proposal.number} waits for an answer: {view.proposal.words}")
    session.output.say(_sentence(view))


@run.command()
@click.argument("id")
@connected
async def watch(session: Session, id: str) -> None:
    """Tell what happens in a run until it is over; with --json one line for each change.

    Ctrl-C ends the watching only. The code at the end is 1 when waypoints were left out.
    """
    await watched(session, await session.server.run(id))


@run.command()
@click.argument("id")
@connected
async def pause(session: Session, id: str) -> None:
    """Have all its drones hold."""
    _changed(session, await session.server.rest.pause_run(id))


@run.command("continue")
@click.argument("id")
@connected
async def go_on(session: Session, id: str) -> None:
    """Let a paused run go on."""
    _changed(session, await session.server.rest.continue_run(id))


@run.command()
@click.argument("id")
@connected
async def stop(session: Session, id: str) -> None:
    """End it: its drones return home."""
    _changed(session, await session.server.rest.stop_run(id))


async def watched(session: Session, run: AsyncRun) -> None:
    """Tells of it until it is over; raises `NotDone` when waypoints were left out."""
    told = 0
    try:
        with session.output.working(f"Run {run.id}") as working:
            async for view in run.progress():
                if session.output.as_json:
                    session.output.json_line(view)
                for explanation in view.explanations:
                    if explanation.number > told:
                        told = explanation.number
                        session.output.say(f"{explanation.at.astimezone():%H:%M:%S} {explanation.words}")
                counts = view.counts
                working.say(f"{view.name}: {view.state}", counts.visited, max(1, counts.waypoints - counts.cancelled))
    except asyncio.CancelledError:
        session.output.note(f"The run goes on. To bring its drones home: dronectl run stop {run.id}")
        raise
    counts = run.view.counts
    session.output.say(_sentence(run.view))
    if counts.visited < counts.waypoints - counts.cancelled:
        raise NotDone(f"{counts.visited} of {counts.waypoints - counts.cancelled} waypoints were visited.")


def _changed(session: Session, view: RunView) -> None:
    session.output.show(view, _sentence(view))


def _sentence(view: RunView) -> str:
    counts = view.counts
    end = f" {view.end}" if view.end else ""
    return f"{view.name} ({view.id}): {view.state}, {counts.visited} of {counts.waypoints} visited.{end}"


def _drones(view: RunView) -> Table:
    rows = [(drone.name, drone.stage, drone.visited, " ".join(drone.next), drone.note) for drone in view.drones]
    return table(("DRONE", "STAGE", "VISITED", "NEXT", "NOTE"), rows)
