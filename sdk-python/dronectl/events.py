"""dronectl events: what happened to drones."""

import asyncio
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path

import click

from dronectl.command import DRONE, Group, connected, drone_option
from dronectl.output import Output, table, text
from dronectl.reading import content
from dronectl.settings import Session, chosen
from dronemap.contract.models import EventGap, NumberedEvent


@click.group(cls=Group)
def events() -> None:
    """What happened to drones."""


@events.command("list")
@click.option("--from", "since", type=click.DateTime(), help="Local time; else an hour ago.")
@click.option("--until", type=click.DateTime(), help="Local time; else now.")
@drone_option
@connected
async def list_events(session: Session, since: datetime | None, until: datetime | None, drone: str | None) -> None:
    """List what was recorded of a drone, oldest first."""
    id = await session.id(drone)
    answer = await session.server.rest.list_drone_events(id, from_=_utc(since), until=_utc(until))
    rows = [(event.at, event.kind, event.text, event.by, event.result, event.reason) for event in answer.events]
    session.output.show(answer, table(("AT", "KIND", "TEXT", "BY", "RESULT", "REASON"), rows))
    if answer.more:
        session.output.note("There is more: say a shorter time with --from and --until.")


@events.command()
@click.argument("names", metavar="[DRONE]...", nargs=-1, type=DRONE)
@click.option("--after", metavar="CURSOR", help="Go on after that; first: from the oldest that the server keeps.")
@click.option(
    "--cursor",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="File to go on from, and to write down in how far it was read.",
)
@connected
async def follow(session: Session, names: tuple[str, ...], after: str | None, file: Path | None) -> None:
    """Tell what happens to drones, all or the named ones, until Ctrl-C.

    It goes on when the connection was cut or the server restarted; where events are missing, it says so. With --json
    each is one line. What was told since the cursor was written may be told once more.
    """
    known = (await session.server.rest.list_drones()).drones
    ids = [chosen(known, name).id for name in names]
    names_by_id = {drone.id: drone.name for drone in known}
    told = await session.server.events(after or _kept(file), ids)
    try:
        async for event in told:
            _tell(session.output, event, names_by_id)
            _keep(file, told.cursor)
    except asyncio.CancelledError:
        # With --timeout it was long enough; that is no failure.
        if session.interrupted:
            session.output.note(f"To go on: dronectl events follow --after {told.cursor}")
            raise
    finally:
        _keep(file, told.cursor)


def _tell(output: Output, event: NumberedEvent | EventGap, names: Mapping[str, str]) -> None:
    if output.as_json:
        output.json_line(event)
    elif isinstance(event, EventGap):
        output.note(f"Events are missing: {event.text}")
    else:
        said = ": ".join(word for word in (event.text, event.result, event.reason) if word)
        output.say(f"{text(event.at)} {names.get(event.drone, event.drone)} {said}")


def _kept(file: Path | None) -> str | None:
    return content(file).decode().strip() or None if file is not None and file.exists() else None


def _keep(file: Path | None, cursor: str) -> None:
    if file is not None and _kept(file) != cursor:
        part = file.with_name(f"{file.name}.part")
        part.write_text(f"{cursor}\n")
        part.replace(file)


def _utc(time: datetime | None) -> str | None:
    return None if time is None else time.astimezone(UTC).isoformat().replace("+00:00", "Z")
