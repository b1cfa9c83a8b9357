"""dronectl record: what the server has recorded of flights."""

from pathlib import Path

import click

from dronectl.command import Group, agreed, connected, drone_option, yes_option
from dronectl.output import table
from dronectl.settings import Session


@click.group(cls=Group)
def record() -> None:
    """Recordings of all messages of a drone, as tlog files."""


@record.command("list")
@drone_option
@connected
async def list_recordings(session: Session, drone: str | None) -> None:
    """List the recordings, of one drone or all."""
    of = None if drone is None else await session.id(drone)
    answer = await session.server.rest.list_recordings(drone=of)
    rows = [
        (found.id, found.drone_name, found.start, found.seconds, found.bytes, found.state, found.notice)
        for found in answer.recordings
    ]
    session.output.show(answer, table(("ID", "DRONE", "START", "SECONDS", "BYTES", "STATE", "NOTICE"), rows))


@record.command()
@click.argument("id")
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path), required=False)
@connected
async def download(session: Session, id: str, file: Path | None) -> None:
    """Write a recording into FILE (else ID.tlog)."""
    with session.output.working(f"Recording {id}"):
        content = await session.server.rest.get_recording_file(id)
    session.output.save(content, file or Path(f"{Path(id).name}.tlog"))


@record.command()
@click.argument("id")
@click.option("--speed", type=float, help="So many times as fast as it was, 1 to 100.")
@connected
async def replay(session: Session, id: str, speed: float | None) -> None:
    """Play a recording at the server: its drones are shown as replayed ones."""
    answer = await session.server.rest.replay_recording(id, speed=speed)
    session.output.show(answer, f"{answer.name}: is played as {answer.id}, at speed {answer.speed:g}.")


@record.command()
@click.argument("id")
@yes_option
@connected
async def delete(session: Session, id: str, yes: bool) -> None:
    """Delete a recording for ever."""
    agreed(yes, f"Delete the recording {id} for ever?")
    await session.server.rest.delete_recording(id, confirm=True)
    session.output.say(f"{id}: deleted.")
