"""All commands under their names."""

import click

from dronectl import (
    about,
    call,
    dispatch,
    drones,
    events,
    flight,
    follow,
    keys,
    logs,
    mission,
    params,
    plan,
    record,
    recovery,
    run,
    users,
)
from dronectl import virtual as virtual_drones
from dronectl import zones as zone
from dronectl.command import Group
from dronemap import __version__

_COMMANDS: tuple[click.Command, ...] = (
    drones.drones,
    drones.watch,
    flight.arm,
    flight.disarm,
    flight.takeoff,
    flight.goto,
    recovery.land,
    flight.rtl,
    flight.hold,
    flight.speed,
    flight.mode,
    mission.mission,
    plan.plan,
    run.run,
    dispatch.send,
    dispatch.dispatch,
    recovery.return_all,
    recovery.recovery,
    follow.follow,
    virtual_drones.virtual,
    zone.zones,
    params.params,
    logs.logs,
    record.record,
    users.users,
    keys.keys,
    events.events,
    about.config,
    about.version,
    about.completion,
    call.operations,
    call.call,
)


class _InOrder(Group):
    """Its commands stand in help in the order above: what is used most comes first."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.commands)


@click.version_option(__version__, message="dronectl %(version)s")
@click.group(cls=_InOrder, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
def cli() -> None:
    """List, watch and command the drones of a Dronemap server.

    The server and the access key come from DRONEMAP_URL and DRONEMAP_KEY, or from a profile in
    ~/.config/dronemap/config.toml (see: dronectl config). A key is never given on the command line, where others
    can read it.
    """


for command in _COMMANDS:
    cli.add_command(command)
