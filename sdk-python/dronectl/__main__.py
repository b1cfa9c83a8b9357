"""dronectl: lists, watches and commands the drones of a Dronemap server."""

import asyncio
import os
import sys
from typing import TYPE_CHECKING

import click

from dronectl.failure import INTERRUPTED, REFUSED, WRONG_USE, exit_code, sentence
from dronectl.output import plain

if TYPE_CHECKING:
    from dronectl.settings import Settings


def main(args: list[str] | None = None, settings: "Settings | None" = None) -> None:
    """Runs what the command line says, and ends with a code: 0 done, 1 refused or failed, 2 wrong use, 3 not known,
    4 no server, 130 interrupted. `args` and `settings` are what tests put in their place."""
    try:
        # Here, since Ctrl-C while all of it is read is no traceback either.
        from dronectl.settings import Settings
        from dronectl.tree import cli

        # Not standalone: it would end with codes of its own. An early end, such as --help, is what it returns then.
        cli.main(args, prog_name="dronectl", standalone_mode=False, obj=settings or Settings())
        sys.stdout.flush()
    except (KeyboardInterrupt, asyncio.CancelledError, click.Abort):
        click.echo("", err=True)
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        # Whoever read has gone, such as `head`: there is nobody to tell.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(REFUSED)
    except click.exceptions.NoArgsIsHelpError as e:
        click.echo(e.format_message(), err=True)
        sys.exit(WRONG_USE)
    except Exception as e:
        if os.environ.get("DRONECTL_DEBUG"):
            raise
        click.echo(f"dronectl: {plain(sentence(e))}", err=True)
        sys.exit(exit_code(e))


if __name__ == "__main__":
    main()
