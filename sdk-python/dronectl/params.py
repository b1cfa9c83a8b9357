"""dronectl params: the parameters of a vehicle."""

import secrets
from pathlib import Path

import click
from rich.table import Table

from dronectl.command import Group, NumbersCommand, agreed, connected, drone_option, yes_option
from dronectl.failure import NotDone
from dronectl.flight import conducted, finished
from dronectl.output import table
from dronectl.reading import FILE, content
from dronectl.settings import Session
from dronemap.command import AsyncCommand
from dronemap.contract.models import ParametersFileView, ParametersView, ParameterValueRequest

_REFRESH = click.option("--refresh", is_flag=True, help="Read them from the vehicle again first.")
_COMMANDS = frozenset({"command"})


@click.group(cls=Group)
def params() -> None:
    """Parameters of a vehicle. Those that were never read are read first."""


@params.command("list")
@click.argument("search", required=False)
@_REFRESH
@drone_option
@connected
async def list_parameters(session: Session, search: str | None, refresh: bool, drone: str | None) -> None:
    """List the parameters whose name has SEARCH in it, or all."""
    answer = await _known(session, await session.id(drone), search, refresh)
    rows = [(found.name, f"{found.value:.7g}", found.type) for found in answer.parameters]
    session.output.show(answer, table(("NAME", "VALUE", "TYPE"), rows))


@params.command()
@click.argument("name")
@_REFRESH
@drone_option
@connected
async def get(session: Session, name: str, refresh: bool, drone: str | None) -> None:
    """Print the value of one parameter."""
    answer = await _known(session, await session.id(drone), name, refresh)
    for found in answer.parameters:
        if found.name == name.upper() or found.name == name:
            session.output.show(found, f"{found.value:.7g}")
            return
    near = ", ".join(found.name for found in answer.parameters[:5])
    raise NotDone(f"The vehicle has no parameter '{name}'{f'; it has {near}' if near else ''}.")


@params.command("set", cls=NumbersCommand)
@click.argument("name")
@click.argument("value", type=float)
@drone_option
@connected
async def set_parameter(session: Session, name: str, value: float, drone: str | None) -> None:
    """Change one parameter; it is read back."""
    id = await session.id(drone)
    asked = ParameterValueRequest(value=value, id=secrets.token_urlsafe(12))
    with session.output.working(name) as working:
        view = await conducted(session, lambda: session.server.rest.set_parameter(id, name, asked), working)
    session.output.show(view, f"{view.summary}: done.")


@params.command()
@click.argument("file", type=click.Path(dir_okay=False, allow_dash=True, path_type=Path))
@click.option(
    "--form",
    type=click.Choice(["list", "table"]),
    default="list",
    help="list: Mission Planner, MAVProxy; table: QGroundControl.",
)
@_REFRESH
@drone_option
@connected
async def save(session: Session, file: Path, form: str, refresh: bool, drone: str | None) -> None:
    """Write all parameters into FILE; - prints them."""
    id = await session.id(drone)
    await _known(session, id, None, refresh)
    saved = await session.server.rest.export_parameters(id, form=form)
    if str(file) == "-":
        session.output.write(saved)
    else:
        session.output.save(saved, file)


@params.command()
@click.argument("file", type=FILE)
@_REFRESH
@drone_option
@connected
async def diff(session: Session, file: Path, refresh: bool, drone: str | None) -> None:
    """Show which parameters of the vehicle differ from FILE."""
    id = await session.id(drone)
    await _known(session, id, None, refresh)
    answer = await session.server.rest.import_parameters(id, content(file), dry_run=True)
    session.output.show(answer, _differences(answer))
    session.output.say(_summary(answer))


@params.command()
@click.argument("file", type=FILE)
@yes_option
@drone_option
@connected
async def load(session: Session, file: Path, yes: bool, drone: str | None) -> None:
    """Change the parameters of the vehicle that differ from FILE; each is read back."""
    id, raw = await session.id(drone), content(file)
    await _known(session, id, None, False)
    wanted = await session.server.rest.import_parameters(id, raw, dry_run=True)
    if not wanted.different:
        session.output.show(wanted, _summary(wanted))
        return
    agreed(yes, f"{_summary(wanted)} Change them?")
    await session.ready()
    told = session.server.stream.messages(_COMMANDS, None)
    answer = await session.server.rest.import_parameters(id, raw)
    if answer.command is not None:
        with session.output.working(answer.command.summary) as working:
            await finished(session, AsyncCommand(answer.command, session.server.rest, told), working)
    session.output.show(answer, _differences(answer))
    session.output.say("They are changed and were read back.")


async def _known(session: Session, id: str, search: str | None, refresh: bool) -> ParametersView:
    answer = await session.server.rest.list_parameters(id, search=search)
    if answer.read_at is not None and not refresh:
        return answer
    with session.output.working("Reading the parameters") as working:
        await conducted(session, lambda: session.server.rest.read_parameters(id), working)
    return await session.server.rest.list_parameters(id, search=search)


def _differences(answer: ParametersFileView) -> Table:
    rows = [(found.name, f"{found.held:.7g}", f"{found.wanted:.7g}") for found in answer.different]
    return table(("NAME", "VEHICLE", "FILE"), rows)


def _summary(answer: ParametersFileView) -> str:
    words = [f"{len(answer.different)} differ, {answer.same} are the same"]
    words += [f"{len(answer.unfit)} are of no fitting value"] if answer.unfit else []
    words += [f"{len(answer.unknown)} are unknown to the vehicle"] if answer.unknown else []
    left_out = [f"Line {left.line}: {left.why}" for left in answer.left_out]
    return "\n".join([f"{', '.join(words)}.", *left_out])
