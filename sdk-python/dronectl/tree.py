"""All commands under their names."""

import click

from dronectl import drones, flight
from dronectl.command import Group


@click.group(cls=Group, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
def cli() -> None:
    """List, watch and command the drones of a Dronemap server.

    The server and the access key come from DRONEMAP_URL and DRONEMAP_KEY, or from a profile in
    ~/.config/dronemap/config.toml (see: dronectl config). A key is never given on the command line, where others
    can read it.
    """


for command in (
    drones.drones,
    drones.watch,
    flight.arm,
    flight.disarm,
    flight.takeoff,
    flight.goto,
    flight.land,
    flight.rtl,
    flight.hold,
    flight.mode,
):
    cli.add_command(command)
