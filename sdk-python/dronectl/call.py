"""dronectl operations and call: all that the server can do, under the contract's own names."""

import inspect
import re
import typing
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem
from pydantic import BaseModel, TypeAdapter, ValidationError
from pydantic.alias_generators import to_camel

from dronectl.command import Command, connected
from dronectl.failure import invalid
from dronectl.operations import COMMANDS, LEFT_OUT
from dronectl.output import Output, members, table
from dronectl.reading import FILE, content, fitted, json_of
from dronectl.settings import Session, Settings
from dronemap.contract.operations import Operations

_CAPITAL = re.compile(r"(?<!^)(?=[A-Z])")


class OperationId(click.types.StringParamType):
    """The name of an operation, such as listDrones."""

    name = "operation"

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        return [CompletionItem(name) for name in sorted({**COMMANDS, **LEFT_OUT}) if name.startswith(incomplete)]


@click.command(cls=Command)
@click.pass_context
def operations(context: click.Context) -> None:
    """List all operations of the server.

    Each with the command that has it, or why none has.
    """
    settings = context.ensure_object(Settings)
    output = Output(settings.as_json)
    if settings.as_json:
        output.json({"commands": COMMANDS, "leftOut": LEFT_OUT})
        return
    rows = [
        (name, f"dronectl {COMMANDS[name]}" if name in COMMANDS else f"call only: {LEFT_OUT[name]}")
        for name in sorted({**COMMANDS, **LEFT_OUT})
    ]
    output.draw(table(("OPERATION", "COMMAND"), rows))


@click.command(cls=Command)
@click.argument("operation", type=OperationId())
@click.argument("parameters", metavar="[PARAMETER=VALUE]...", nargs=-1)
@click.option("--body", type=FILE, help="File of what is sent; - is the standard input.")
@click.option("--output", "file", type=click.Path(dir_okay=False, path_type=Path), help="Write the answer there.")
@connected
async def call(
    session: Session, operation: str, parameters: tuple[str, ...], body: Path | None, file: Path | None
) -> None:
    """Call any OPERATION of the server.

    Its answer is printed as JSON. Operations are listed by: dronectl operations.

    \b
    dronectl call getDrone id=dksghuu5qf
    dronectl call renameDrone id=dksghuu5qf --body name.json
    """
    method = getattr(session.server.rest, _snake(operation), None)
    if method is None or operation not in {**COMMANDS, **LEFT_OUT}:
        raise _wrong(f"There is no operation '{operation}'. They are listed by: dronectl operations.")
    arguments = _arguments(operation, method, parameters, body)
    answer = await method(**arguments)
    if answer is None:
        return
    if isinstance(answer, bytes):
        _bytes(session.output, answer, file)
    elif isinstance(answer, BaseModel) and file is None:
        session.output.json(members(answer))
    else:
        text = answer.model_dump_json(by_alias=True, exclude_unset=True) if isinstance(answer, BaseModel) else answer
        _bytes(session.output, f"{text}\n".encode(), file)


def _arguments(operation: str, method: Any, given: tuple[str, ...], body: Path | None) -> dict[str, Any]:
    types = typing.get_type_hints(getattr(Operations, _snake(operation)))
    signature = inspect.signature(method).parameters
    known = {_contract_name(name): name for name in signature if name != "body"}
    arguments: dict[str, Any] = {}
    for word in given:
        name, equals, value = word.partition("=")
        if not equals or name not in known:
            raise _wrong(f"'{word}' is no PARAMETER=VALUE of {operation}; it has {', '.join(known) or 'none'}.")
        arguments[known[name]] = _value(name, value, types[known[name]])
    if body is not None:
        if "body" not in signature:
            raise _wrong(f"{operation} takes no --body.")
        raw = types["body"] is bytes
        arguments["body"] = content(body) if raw else fitted(body, json_of(body), types["body"])
    missing = [
        "--body FILE" if name == "body" else f"{_contract_name(name)}=…"
        for name, parameter in signature.items()
        if parameter.default is inspect.Parameter.empty and name not in arguments
    ]
    if missing:
        raise _wrong(f"{operation} needs {' and '.join(missing)}.")
    return arguments


def _value(name: str, value: str, wanted: Any) -> Any:
    try:
        return TypeAdapter(wanted).validate_python(value)
    except ValidationError as e:
        raise _wrong(f"{name}: {invalid(e)}") from e


def _bytes(output: Output, answer: bytes, file: Path | None) -> None:
    if file is not None:
        output.save(answer, file)
    elif output.console.is_terminal and b"\0" in answer:
        raise _wrong("The answer is no text: say where to write it with --output FILE.")
    else:
        output.write(answer)


def _wrong(words: str) -> click.UsageError:
    return click.UsageError(words, click.get_current_context(silent=True))


def _snake(operation: str) -> str:
    return _CAPITAL.sub("_", operation).lower()


def _contract_name(name: str) -> str:
    return to_camel(name.rstrip("_"))
