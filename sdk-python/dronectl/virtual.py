"""dronectl virtual: drones that are bound to a real one when their mission is flown."""

import asyncio
from pathlib import Path

import click

from dronectl.command import Group, agreed, connected, yes_option
from dronectl.flight import NO_WAIT
from dronectl.mission_file import read_mission
from dronectl.output import table
from dronectl.reading import FILE
from dronectl.settings import Session, one
from dronemap.contract.models import VirtualDroneRequest, VirtualDroneStartRequest, VirtualDroneView
from dronemap.virtual import AsyncVirtualDrone


@click.group(cls=Group)
def virtual() -> None:
    """Virtual drones: each by its name or id."""


@virtual.command("list")
@connected
async def list_virtual(session: Session) -> None:
    """List the virtual drones."""
    answer = await session.server.rest.list_virtual_drones()
    rows = [
        (view.name, view.id, view.owner, len(view.items or []), view.run.sentence if view.run else None)
        for view in answer.virtual_drones
    ]
    session.output.show(answer, table(("NAME", "ID", "OWNER", "ITEMS", "MISSION"), rows))


@virtual.command()
@click.argument("name")
@click.argument("file", type=FILE, required=False)
@click.option("--up-to", type=click.IntRange(1, 8), metavar="N", help="So many drones may share its mission.")
@connected
async def add(session: Session, name: str, file: Path | None, up_to: int | None) -> None:
    """Make a virtual drone, with the mission of FILE."""
    items = None if file is None else read_mission(file).items
    asked = VirtualDroneRequest(name=name, items=items, up_to=up_to)
    view = await session.server.rest.add_virtual_drone(asked)
    session.output.show(view, f"{view.name}: made as {view.id}.")


@virtual.command()
@click.argument("name")
@click.option("--on-cloud-loss", type=click.Choice(["continue", "rtl"]), help="When it hears the server no more.")
@NO_WAIT
@connected
async def start(session: Session, name: str, on_cloud_loss: str | None, no_wait: bool) -> None:
    """Have its mission flown, and wait for the end.

    Ctrl-C ends the waiting only: the mission goes on.
    """
    found = await _found(session, name)
    asked = VirtualDroneStartRequest.model_validate({"on_cloud_loss": on_cloud_loss})
    view = await session.server.rest.start_virtual_drone(found.id, asked)
    if no_wait:
        session.output.show(view, _sentence(view))
    else:
        await _watched(session, view)


@virtual.command()
@click.argument("name")
@connected
async def stop(session: Session, name: str) -> None:
    """Stop its mission: the drone that serves it comes home."""
    view = await session.server.rest.stop_virtual_drone((await _found(session, name)).id)
    session.output.show(view, _sentence(view))


@virtual.command("continue")
@click.argument("name")
@connected
async def go_on(session: Session, name: str) -> None:
    """Go on with what of its mission is not flown yet."""
    view = await session.server.rest.resume_virtual_drone((await _found(session, name)).id)
    session.output.show(view, _sentence(view))


@virtual.command()
@click.argument("name")
@yes_option
@connected
async def remove(session: Session, name: str, yes: bool) -> None:
    """Remove a virtual drone and its mission."""
    found = await _found(session, name)
    agreed(yes, f"Remove the virtual drone {found.name}?")
    await session.server.rest.remove_virtual_drone(found.id)
    session.output.say(f"{found.name}: removed.")


@virtual.command()
@click.argument("name")
@connected
async def watch(session: Session, name: str) -> None:
    """Tell how its mission goes on until it is over; with --json one line for each change."""
    await _watched(session, await _found(session, name))


async def _watched(session: Session, view: VirtualDroneView) -> None:
    drone = AsyncVirtualDrone(view, session.server.rest, session.server.stream)
    told = ""
    try:
        with session.output.working(view.name) as working:
            async for now in drone.progress():
                if session.output.as_json:
                    session.output.json_line(now)
                elif _sentence(now) != told:
                    told = _sentence(now)
                    session.output.say(told)
                if now.run is not None and now.run.total:
                    working.say(now.name, now.run.flown, now.run.total)
    except asyncio.CancelledError:
        session.output.note(f"{view.name} goes on. To bring its drone home: dronectl virtual stop {view.id}")
        raise
    await drone.wait()


def _sentence(view: VirtualDroneView) -> str:
    return f"{view.name}: {view.run.sentence if view.run else 'its mission was never started.'}"


async def _found(session: Session, name: str) -> VirtualDroneView:
    return one("virtual drone", (await session.server.rest.list_virtual_drones()).virtual_drones, name)
