"""The base of all commands: the options that each of them has, and a session to work with."""

import functools
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, Concatenate, ParamSpec, TypeVar

import click
from click.shell_completion import CompletionItem

from dronectl.failure import NotAnswered
from dronectl.names import drone_names
from dronectl.settings import Session, Settings

Arguments = ParamSpec("Arguments")
Function = TypeVar("Function", bound=Callable[..., Any])


def _set(context: click.Context, parameter: click.Parameter, value: Any) -> None:
    settings = context.ensure_object(Settings)
    if value is not None and value is not False:
        assert parameter.name is not None
        setattr(settings, parameter.name, value)


def shared_options() -> list[click.Parameter]:
    """The options of all commands; they may stand before and after the command's name."""
    path = click.Path(dir_okay=False, path_type=Path)
    shared: dict[str, Any] = {"callback": _set, "expose_value": False, "is_eager": True}
    return [
        click.Option(["--url"], metavar="ADDRESS", help="Address of the server (DRONEMAP_URL).", **shared),
        click.Option(["--key-file"], type=path, help="File that holds the access key (else DRONEMAP_KEY).", **shared),
        click.Option(["--profile"], metavar="NAME", help="Part of the file of profiles to use.", **shared),
        click.Option(["--json", "as_json"], is_flag=True, help="Print the server's objects as JSON.", **shared),
        click.Option(
            ["--timeout"],
            type=click.FloatRange(min=0, min_open=True),
            metavar="SECONDS",
            help="Wait no longer than that.",
            **shared,
        ),
    ]


class Command(click.Command):
    """A command with the options of all."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.params = [*self.params, *shared_options()]


class NumbersCommand(Command):
    """A command whose arguments may be negative numbers, such as degrees to the south, which look like options."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        ctx.ignore_unknown_options = True
        unknown = [arg for arg in args if arg.startswith("--") and len(arg) > 2 and not self._has(ctx, arg)]
        if unknown:
            raise click.NoSuchOption(unknown[0], ctx=ctx)
        return super().parse_args(ctx, args)

    def _has(self, ctx: click.Context, arg: str) -> bool:
        name = arg.split("=", 1)[0]
        return any(name in (*parameter.opts, *parameter.secondary_opts) for parameter in self.get_params(ctx))


class Group(click.Group):
    """A group of such commands."""

    command_class = Command
    group_class = type

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.params = [*self.params, *shared_options()]


def connected(
    work: Callable[Concatenate[Session, Arguments], Awaitable[None]],
) -> Callable[Arguments, None]:
    """A command that gets a session with the server as its first argument."""

    @functools.wraps(work)
    def command(*args: Arguments.args, **kwargs: Arguments.kwargs) -> None:
        settings = click.get_current_context().ensure_object(Settings)
        settings.run(lambda session: work(session, *args, **kwargs))

    return command


class DroneName(click.types.StringParamType):
    """The name or id of a drone; the shell completes it by asking the server."""

    name = "drone"

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        settings = ctx.find_object(Settings) or Settings()
        return [
            CompletionItem(word, help=explained)
            for word, explained in drone_names(settings)
            if word.startswith(incomplete)
        ]


DRONE = DroneName()


def drone_option(function: Function) -> Function:
    """--drone, for commands that concern one drone."""
    return click.option("-d", "--drone", type=DRONE, metavar="DRONE", help="Name or id; else the only drone.")(function)


def yes_option(function: Function) -> Function:
    return click.option("--yes", is_flag=True, help="Do not ask.")(function)


def agreed(yes: bool, question: str) -> None:
    """Returns when the user wants it; where nobody can be asked, only --yes says so."""
    if yes:
        return
    if not sys.stdin.isatty():
        raise NotAnswered(f"{question} Nobody is there to ask: say --yes.")
    if not click.confirm(question, err=True):
        raise NotAnswered("Nothing was done.")
