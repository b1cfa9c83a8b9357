"""dronectl events: what happened to drones."""

from datetime import UTC, datetime

import click

from dronectl.command import Group, connected, drone_option
from dronectl.output import table
from dronectl.settings import Session


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


def _utc(time: datetime | None) -> str | None:
    return None if time is None else time.astimezone(UTC).isoformat().replace("+00:00", "Z")
