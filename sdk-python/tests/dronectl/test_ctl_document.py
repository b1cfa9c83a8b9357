"""The user's page names what there is."""

from pathlib import Path

import click
import pytest
from test_ctl_call import commands

from dronectl.tree import cli

PAGE = (Path(__file__).parents[2] / "dronectl.md").read_text()


@pytest.mark.parametrize(("path", "command"), commands(cli, ""))
def test_page_names_each_command(path: str, command: click.Command) -> None:
    assert f"dronectl {path}" in PAGE
    own = [parameter for parameter in command.params if isinstance(parameter, click.Option) and parameter.expose_value]
    for option in own:
        assert max(option.opts, key=len) in PAGE, f"{path}: {option.opts}"
