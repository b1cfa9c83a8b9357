"""dronectl users: who may sign in."""

import secrets
from pathlib import Path

import click

from dronectl.command import Group, agreed, connected, yes_option
from dronectl.output import table
from dronectl.reading import FILE, content, fitted
from dronectl.settings import Session
from dronemap.contract.models import NewUser, UserChange, UserView

ROLES = ("reporter", "viewer", "planner", "operator", "supervisor", "administrator")


@click.group(cls=Group)
def users() -> None:
    """Users of your organisation (administrators)."""


@users.command("list")
@connected
async def list_users(session: Session) -> None:
    """List the users."""
    answer = await session.server.rest.list_users()
    rows = [(user.name, user.role, user.state, user.must_change_password, user.only_granted) for user in answer.users]
    columns = ("NAME", "ROLE", "STATE", "PASSWORD TO CHANGE", "ONLY GRANTED")
    session.output.show(answer, table(columns, rows))


@users.command()
@click.argument("name")
@click.argument("role", type=click.Choice(ROLES))
@click.option("--password-file", type=FILE, help="First password; - is the standard input. Else one is made up.")
@connected
async def add(session: Session, name: str, role: str, password_file: Path | None) -> None:
    """Add a user. The password serves for the first sign-in, and is then changed."""
    made_up = password_file is None
    password = secrets.token_urlsafe(12) if password_file is None else content(password_file).decode().strip()
    asked = fitted("The user", {"name": name, "role": role, "password": password}, NewUser)
    user = await session.server.rest.add_user(asked)
    session.output.show(user, _sentence(user))
    if made_up:
        session.output.note(f"First password, shown this once: {password}")


@users.command()
@click.argument("name")
@click.argument("role", type=click.Choice(ROLES))
@connected
async def role(session: Session, name: str, role: str) -> None:
    """Give a user another role."""
    user = await session.server.rest.change_user(name, UserChange.model_validate({"role": role}))
    session.output.show(user, _sentence(user))


@users.command()
@click.argument("name")
@connected
async def enable(session: Session, name: str) -> None:
    """Let a user in who waits or was disabled."""
    user = await session.server.rest.change_user(name, UserChange(state="active"))
    session.output.show(user, _sentence(user))


@users.command()
@click.argument("name")
@connected
async def disable(session: Session, name: str) -> None:
    """Keep a user out: ends sessions and makes access keys void, until the user is enabled."""
    user = await session.server.rest.change_user(name, UserChange(state="disabled"))
    session.output.show(user, _sentence(user))


@users.command()
@click.argument("name")
@yes_option
@connected
async def delete(session: Session, name: str, yes: bool) -> None:
    """Delete a user with sessions and access keys."""
    agreed(yes, f"Delete the user {name} with all access keys?")
    await session.server.rest.delete_user(name)
    session.output.say(f"{name}: deleted.")


@users.command("reset-password")
@click.argument("name")
@yes_option
@connected
async def reset_password(session: Session, name: str, yes: bool) -> None:
    """Make a one-time password for a user, and print it."""
    agreed(yes, f"Make the present password of {name} void?")
    made = await session.server.rest.reset_password(name)
    session.output.show(made, made.password)


def _sentence(user: UserView) -> str:
    return f"{user.name}: {user.role}, {user.state}."
