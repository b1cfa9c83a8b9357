"""dronectl keys: one's own access keys."""

import os
from collections.abc import Awaitable, Callable
from pathlib import Path

import click

from dronectl.command import DRONE, Group, agreed, connected, yes_option
from dronectl.output import table
from dronectl.reading import fitted
from dronectl.settings import Session, chosen
from dronectl.users import ROLES
from dronemap.contract.models import KeyRequest, KeyView

_OWN = click.option(
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write the key into this file, which only you may read, instead of printing it.",
)


@click.group(cls=Group)
def keys() -> None:
    """Your own access keys: what programs sign in with."""


@keys.command("list")
@connected
async def list_keys(session: Session) -> None:
    """List your access keys; the keys themselves are known to nobody."""
    answer = await session.server.rest.list_access_keys()
    rows = [
        (
            key.id,
            key.label,
            key.role,
            ", ".join(key.operations),
            None if key.drones is None else len(key.drones),
            key.expires_at,
            key.last_used_at,
        )
        for key in answer.access_keys
    ]
    session.output.show(answer, table(("ID", "LABEL", "ROLE", "OPERATIONS", "DRONES", "EXPIRES", "LAST USED"), rows))


@keys.command()
@click.argument("label")
@click.option("--role", type=click.Choice(ROLES), help="Not above your own, which it is when left out.")
@click.option("--days", type=int, help="How long it is good, 1 to 3650; else until it is deleted.")
@click.option("-d", "--drone", "drones", type=DRONE, multiple=True, help="Good for these drones only.")
@click.option(
    "--operation",
    "operations",
    type=click.Choice(["view", "plan", "command", "administer"]),
    multiple=True,
    help="Good for these only.",
)
@_OWN
@connected
async def make(
    session: Session,
    label: str,
    role: str | None,
    days: int | None,
    drones: tuple[str, ...],
    operations: tuple[str, ...],
    file: Path | None,
) -> None:
    """Make an access key, and print it: it is never shown again."""
    asked: dict[str, object] = {"label": label, "role": role, "days": days}
    if drones:
        known = (await session.server.rest.list_drones()).drones
        asked["drones"] = [chosen(known, name).id for name in drones]
    if operations:
        asked["operations"] = list(operations)
    wanted = fitted("The key", {name: value for name, value in asked.items() if value is not None}, KeyRequest)
    await _hand_out(session, lambda: session.server.rest.make_access_key(wanted), file)


@keys.command()
@click.argument("id")
@_OWN
@connected
async def renew(session: Session, id: str, file: Path | None) -> None:
    """Make a new key in place of one, and print it: the old one ends."""
    await _hand_out(session, lambda: session.server.rest.renew_access_key(id), file)


@keys.command()
@click.argument("id")
@yes_option
@connected
async def delete(session: Session, id: str, yes: bool) -> None:
    """Delete an access key and those that were made with it."""
    agreed(yes, f"Delete the access key {id}? Programs that use it stop.")
    await session.server.rest.delete_access_key(id)
    session.output.say(f"{id}: deleted.")


async def _hand_out(session: Session, make: Callable[[], Awaitable[KeyView]], file: Path | None) -> None:
    if file is None:
        made = await make()
        session.output.show(made, made.key or "")
        return
    # Opened first: a key that cannot be written would be lost. What stands in the file stays until there is one.
    with os.fdopen(os.open(file, os.O_WRONLY | os.O_CREAT, 0o600), "w") as opened:
        os.fchmod(opened.fileno(), 0o600)
        made = await make()
        opened.truncate()
        opened.write(f"{made.key}\n")
    session.output.note(f"{file}: the access key {made.label} ({made.id}).")
