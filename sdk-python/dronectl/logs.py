"""dronectl logs: the vehicle's own log files."""

import re
from pathlib import Path

import click

from dronectl.command import Group, agreed, connected, drone_option, yes_option
from dronectl.flight import conducted
from dronectl.output import table
from dronectl.settings import Session
from dronemap.contract.models import LogsView

_NO_FILE_NAME = re.compile(r"[^\w.-]+")


@click.group(cls=Group)
def logs() -> None:
    """Logs that the vehicle keeps itself."""


@logs.command("list")
@drone_option
@connected
async def list_logs(session: Session, drone: str | None) -> None:
    """List the logs as the vehicle listed them last."""
    id = await session.id(drone)
    answer = await session.server.rest.list_logs(id)
    if answer.logs is None:
        answer = await _read(session, id)
    _show(session, answer)


@logs.command()
@drone_option
@connected
async def read(session: Session, drone: str | None) -> None:
    """Have the vehicle list its logs again."""
    _show(session, await _read(session, await session.id(drone)))


@logs.command()
@click.argument("number", type=int)
@click.argument("file", type=click.Path(dir_okay=False, path_type=Path), required=False)
@drone_option
@connected
async def download(session: Session, number: int, file: Path | None, drone: str | None) -> None:
    """Fetch a log from the vehicle into FILE (else DRONE-NUMBER.bin).

    A later attempt goes on where one ended.
    """
    state = await session.view(drone)
    known = await session.server.rest.list_logs(state.id)
    if known.logs is None:
        known = await _read(session, state.id)
    if not any(log.number == number and log.here for log in known.logs or []):
        with session.output.working(f"{state.name}: log {number}") as working:
            await conducted(session, lambda: session.server.rest.download_log(state.id, number), working)
    content = await session.server.rest.get_log_file(state.id, number)
    session.output.save(content, file or Path(f"{_NO_FILE_NAME.sub('-', state.name)}-{number}.bin"))


@logs.command()
@click.argument("number", type=int)
@yes_option
@drone_option
@connected
async def delete(session: Session, number: int, yes: bool, drone: str | None) -> None:
    """Delete the server's copy of a log; the vehicle keeps its own."""
    state = await session.view(drone)
    agreed(yes, f"Delete the server's copy of log {number} of {state.name}?")
    await session.server.rest.delete_log_file(state.id, number)
    session.output.say(f"{state.name}: the copy of log {number} is deleted.")


async def _read(session: Session, id: str) -> LogsView:
    with session.output.working("Listing the logs") as working:
        await conducted(session, lambda: session.server.rest.read_logs(id), working)
    return await session.server.rest.list_logs(id)


def _show(session: Session, answer: LogsView) -> None:
    rows = [(log.number, log.at, log.size_bytes, log.here) for log in answer.logs or []]
    session.output.show(answer, table(("NUMBER", "AT", "BYTES", "ON SERVER"), rows))
