"""dronectl config, version and completion."""

import os
from collections.abc import Mapping
from pathlib import Path

import click
from click.shell_completion import get_completion_class

from dronectl.command import Command
from dronectl.output import Output, table
from dronectl.settings import Session, Settings
from dronemap import NotConfigured, __version__, find_server

#: The name that click makes of the program's.
COMPLETE_VARIABLE = "_DRONECTL_COMPLETE"
_SHELLS = ("bash", "zsh", "fish")


@click.command(cls=Command)
@click.pass_context
def config(context: click.Context) -> None:
    """Show where url and access key come from.

    The key itself is never shown.
    """
    settings = context.ensure_object(Settings)
    server = find_server(settings.url, settings.key(), profile=settings.profile)
    rows = [
        ("url", server.url, _url_from(settings)),
        ("key", "is there", _key_from(settings)),
        ("certificate", server.certificate or "of the system", _certificate_from(server.certificate)),
    ]
    output = Output(settings.as_json)
    if settings.as_json:
        output.json({name: {"value": value, "from": origin} for name, value, origin in rows})
    else:
        output.draw(table(("WHAT", "VALUE", "FROM"), rows))


@click.command(cls=Command)
@click.pass_context
def version(context: click.Context) -> None:
    """Show the version of dronectl and of the server."""
    settings = context.ensure_object(Settings)
    if not settings.as_json:
        click.echo(f"dronectl {__version__}")
    settings.run(_server_version)


async def _server_version(session: Session) -> None:
    server = (await session.server.rest.get_settings()).version
    if session.output.as_json:
        session.output.json({"client": __version__, "server": server})
    else:
        session.output.say(f"server {server}")


@click.command(cls=Command)
@click.argument("shell", type=click.Choice(_SHELLS))
@click.pass_context
def completion(context: click.Context, shell: str) -> None:
    """Print the completion for a shell.

    It completes commands, options, and the names of drones.

    \b
    bash: eval "$(dronectl completion bash)"       in ~/.bashrc
    zsh:  eval "$(dronectl completion zsh)"        in ~/.zshrc, after compinit
    fish: dronectl completion fish > ~/.config/fish/completions/dronectl.fish
    """
    kind = get_completion_class(shell)
    assert kind is not None
    click.echo(kind(context.find_root().command, {}, "dronectl", COMPLETE_VARIABLE).source())


def profiles_file(environment: Mapping[str, str] = os.environ) -> Path:
    """The file of profiles, as `find_server` looks for it."""
    if "DRONEMAP_CONFIG" in environment:
        return Path(environment["DRONEMAP_CONFIG"])
    folder = environment.get("XDG_CONFIG_HOME") or Path.home() / ".config"
    return Path(folder) / "dronemap" / "config.toml"


def _url_from(settings: Settings) -> str:
    if settings.url:
        return "--url"
    if os.environ.get("DRONEMAP_URL"):
        return "DRONEMAP_URL"
    of_file = find_server(key="any", profile=settings.profile).url
    return _profile(settings) if of_file != find_server(key="any", environment=_no_file()).url else "this machine"


def _key_from(settings: Settings) -> str:
    if settings.key_file:
        return f"--key-file {settings.key_file}"
    if os.environ.get("DRONEMAP_KEY"):
        return "DRONEMAP_KEY"
    try:
        alone = find_server(settings.url, environment=_no_file()).key
    except NotConfigured:
        return _profile(settings)
    found = find_server(settings.url, profile=settings.profile).key
    return ".data/local-key of the checkout" if found == alone else _profile(settings)


def _certificate_from(certificate: str | None) -> str:
    if certificate is None:
        return ""
    return "DRONEMAP_CERTIFICATE" if os.environ.get("DRONEMAP_CERTIFICATE") else "profile"


def _profile(settings: Settings) -> str:
    name = settings.profile or os.environ.get("DRONEMAP_PROFILE") or "default"
    return f"profile {name} in {profiles_file()}"


def _no_file() -> dict[str, str]:
    """The environment without the file of profiles."""
    kept = {name: value for name, value in os.environ.items() if name != "DRONEMAP_PROFILE"}
    return kept | {"DRONEMAP_CONFIG": os.devnull}
