"""dronectl mission: missions of drones, and those that are saved on the server."""

import asyncio
import json
from pathlib import Path

import click
from rich.table import Table

from dronectl.command import Group, agreed, connected, drone_option, yes_option
from dronectl.failure import NotDone
from dronectl.flight import NO_WAIT, Interruptible, carried_out, seen, told
from dronectl.mission_file import read_mission
from dronectl.output import Working, members, place, table
from dronectl.reading import FILE
from dronectl.settings import Session, one
from dronemap.arrival import mission_over
from dronemap.contract.models import (
    ArmCommand,
    ClearMissionCommand,
    CommandView,
    DroneView,
    MissionItemRequest,
    MissionItemView,
    MissionRequest,
    PauseMissionCommand,
    SavedMissionView,
    StartMissionCommand,
    UploadMissionCommand,
)
from dronemap.drone import AsyncDrone

_CLOUD_LOSS = click.option(
    "--on-cloud-loss",
    type=click.Choice(["continue", "rtl"]),
    help="What the vehicle does when it hears the server no more.",
)
#: Vehicles say once a second how far their mission is.
_BEGINS_SECONDS = 5.0
#: What the server takes when a mission is uploaded.
_PLANNED = frozenset(
    {"takeOff", "waypoint", "returnToLaunch", "land", "wait", "takePhoto", "setServo", "lookAt", "lookAhead"}
)


@click.group(cls=Group)
def mission() -> None:
    """Missions: on drones, in files, and saved on the server.

    A FILE is JSON (a list of items, or an object with "items"), a .plan of QGroundControl, or a "QGC WPL 110"
    .waypoints file. What Dronemap cannot take over of the latter two is refused, with its item.
    """


@mission.command("list")
@connected
async def list_saved(session: Session) -> None:
    """List the missions that are saved on the server."""
    answer = await session.server.rest.list_missions()
    rows = [(saved.name, saved.id, len(saved.items), saved.by, saved.changed_at) for saved in answer.missions]
    session.output.show(answer, table(("NAME", "ID", "ITEMS", "BY", "CHANGED"), rows))


@mission.command()
@click.argument("saved", metavar="[MISSION]", required=False)
@drone_option
@connected
async def show(session: Session, saved: str | None, drone: str | None) -> None:
    """Show the mission of the drone, or a saved one.

    A saved MISSION is said by its name or id.
    """
    if saved is not None:
        found = await _saved(session, saved)
        session.output.show(found, _drawn(found.items))
        return
    state = await session.view(drone)
    flown = state.mission
    if flown.items is None and not session.output.as_json:
        raise NotDone(_unknown(state))
    session.output.show(flown, _drawn(flown.items or [], flown.current))


@mission.command()
@click.argument("file", type=FILE)
@click.argument("name")
@connected
async def save(session: Session, file: Path, name: str) -> None:
    """Save the mission of FILE on the server under NAME."""
    answer = await session.server.rest.add_mission(MissionRequest(name=name, items=_items(session, file)))
    session.output.show(answer, f"{answer.name}: saved with {len(answer.items)} items as {answer.id}.")


@mission.command()
@click.argument("saved", metavar="MISSION")
@yes_option
@connected
async def delete(session: Session, saved: str, yes: bool) -> None:
    """Delete a saved mission."""
    found = await _saved(session, saved)
    agreed(yes, f"Delete the mission {found.name} ({len(found.items)} items)?")
    await session.server.rest.delete_mission(found.id)
    session.output.say(f"{found.name}: deleted.")


@mission.command()
@click.argument("file", type=FILE)
@drone_option
@connected
async def upload(session: Session, file: Path, drone: str | None) -> None:
    """Bring the mission of FILE to the drone.

    It takes the place of the one that it has.
    """
    items = _items(session, file)
    await told(session, await session.drone(drone), UploadMissionCommand(items=items))


@mission.command()
@click.argument("file", type=FILE)
@_CLOUD_LOSS
@NO_WAIT
@drone_option
@connected
async def fly(session: Session, file: Path, on_cloud_loss: str | None, no_wait: bool, drone: str | None) -> None:
    """Upload the mission of FILE, arm, start it, and wait for its end.

    Ctrl-C while it flies: the drone holds.
    """
    items = _items(session, file)
    flown = await session.drone(drone)
    with session.output.working(f"{flown.name}: upload") as working:
        await carried_out(session, flown, UploadMissionCommand(items=items), working)
    await _started(session, flown, on_cloud_loss, no_wait)


@mission.command()
@_CLOUD_LOSS
@NO_WAIT
@drone_option
@connected
async def start(session: Session, on_cloud_loss: str | None, no_wait: bool, drone: str | None) -> None:
    """Start the mission that the drone has.

    It is armed where that is needed; dronectl waits for the end. Ctrl-C while it flies: the drone holds.
    """
    await _started(session, await session.drone(drone), on_cloud_loss, no_wait)


@mission.command()
@drone_option
@connected
async def pause(session: Session, drone: str | None) -> None:
    """Pause the mission; start goes on with it."""
    await told(session, await session.drone(drone), PauseMissionCommand())


@mission.command()
@yes_option
@drone_option
@connected
async def clear(session: Session, yes: bool, drone: str | None) -> None:
    """Delete the mission on the drone."""
    flown = await session.drone(drone)
    agreed(yes, f"Delete the mission on {flown.name}?")
    await told(session, flown, ClearMissionCommand())


@mission.command()
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path), required=False)
@drone_option
@connected
async def download(session: Session, file: Path | None, drone: str | None) -> None:
    """Write the mission of the drone as JSON into FILE, or print it."""
    state = await session.view(drone)
    items = state.mission.items
    if not items:
        raise NotDone(f"{state.name} has no mission." if items == [] else _unknown(state))
    foreign = sum(members(item)["type"] not in _PLANNED for item in items)
    if foreign:
        session.output.note(f"{foreign} of its items are none of Dronemap's: the file cannot be uploaded as it is.")
    written = json.dumps({"items": [members(item) for item in items]}, indent=2, ensure_ascii=False) + "\n"
    if file is None:
        session.output.write(written.encode())
    else:
        session.output.save(written.encode(), file)


async def _started(session: Session, drone: AsyncDrone, on_cloud_loss: str | None, no_wait: bool) -> None:
    command = StartMissionCommand.model_validate({"on_cloud_loss": on_cloud_loss} if on_cloud_loss else {})
    async with Interruptible(session, drone, "hold"):
        with session.output.working(f"{drone.name}: start of the mission") as working:
            if not drone.state.armed:
                await carried_out(session, drone, ArmCommand(), working)
            view: CommandView = await carried_out(session, drone, command, working)
            if not no_wait:
                await _begun(session, drone, working)
                await seen(session, drone, mission_over, "at the end of its mission", working, _item_of)
    session.output.show(view, f"{drone.name}: its mission is {'started' if no_wait else 'over'}.")


async def _begun(session: Session, drone: AsyncDrone, working: Working) -> None:
    """Returns when it flies: what the vehicle said of a mission before may still stand for a moment."""
    try:
        async with asyncio.timeout(_BEGINS_SECONDS):
            await seen(session, drone, _flies_it, "flying its mission", working, _item_of)
    except TimeoutError:
        # It was flown faster than that was told, or the vehicle says nothing of it: how it is now counts.
        return


def _flies_it(state: DroneView) -> bool:
    return state.armed is True and state.mission.state != "complete"


def _item_of(state: DroneView) -> str:
    current, total = state.mission.current, state.mission.total
    if current is None:
        return ""
    # The contract counts from 0, people from 1.
    return f", item {current + 1}{f' of {total}' if total else ''}"


async def _saved(session: Session, wanted: str) -> SavedMissionView:
    return one("mission", (await session.server.rest.list_missions()).missions, wanted)


def _items(session: Session, file: Path) -> list[MissionItemRequest]:
    found = read_mission(file)
    for words in found.left_out:
        session.output.note(f"{file}: {words}.")
    return found.items


def _unknown(state: DroneView) -> str:
    return f"What mission {state.name} has is not known{f': {state.mission.notice}' if state.mission.notice else ''}."


def _drawn(items: list[MissionItemView], current: int | None = None) -> Table:
    rows = []
    for index, item in enumerate(items):
        one_item = members(item)
        height = one_item.get("altitude")
        reference = one_item.get("altitudeReference") or "home"
        more = [f"{one_item['holdSeconds']:g} s"] if one_item.get("holdSeconds") else []
        more += [f"output {one_item['output']}: {one_item['pulse']} µs"] if "output" in one_item else []
        more += [one_item["description"]] if "description" in one_item else []
        rows.append(
            (
                f"{index + 1}{' <' if index == current else ''}",
                one_item["type"],
                place(one_item.get("latitude"), one_item.get("longitude")),
                None if height is None else f"{height:g} m above {'sea level' if reference == 'amsl' else reference}",
                ", ".join(more),
            )
        )
    return table(("ITEM", "TYPE", "PLACE", "HEIGHT", "MORE"), rows)
