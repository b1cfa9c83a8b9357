"""Files of the user: read whole, and refused with the place of what is wrong in them."""

import json
import sys
from pathlib import Path
from typing import Any, TypeVar

import click
from pydantic import TypeAdapter, ValidationError

from dronectl.failure import BadFile, invalid

Wanted = TypeVar("Wanted")

#: A file that has to be there; - is the standard input.
FILE = click.Path(exists=True, dir_okay=False, allow_dash=True, path_type=Path)


def content(file: Path) -> bytes:
    try:
        return sys.stdin.buffer.read() if str(file) == "-" else file.read_bytes()
    except OSError as e:
        raise BadFile(f"{file} cannot be read: {e.strerror}") from e


def json_of(file: Path, raw: bytes | None = None) -> Any:
    """What stands in a file of JSON."""
    try:
        return json.loads(content(file) if raw is None else raw)
    except ValueError as e:
        raise BadFile(f"{file} is no JSON: {e}") from e


def fitted(source: object, given: Any, wanted: Any) -> Any:
    """The members as that type of the contract; a member that it does not have is refused, not passed over."""
    adapter: TypeAdapter[Any] = TypeAdapter(wanted)
    try:
        value = adapter.validate_python(given)
    except ValidationError as e:
        raise BadFile(f"{source}: {invalid(e)}") from e
    taken = adapter.dump_python(value, mode="json", by_alias=True, exclude_unset=True)
    unknown = _unknown(given, taken, "")
    if unknown is not None:
        raise BadFile(f"{source}: there is no member {unknown}.")
    return value


def _unknown(given: Any, taken: Any, where: str) -> str | None:
    pairs: list[tuple[Any, Any, str]] = []
    if isinstance(given, dict) and isinstance(taken, dict):
        for name, value in given.items():
            if name not in taken:
                return f"{where}{name}"
            pairs.append((value, taken[name], f"{where}{name}."))
    elif isinstance(given, list) and isinstance(taken, list):
        pairs = [(value, taken[i], f"{where}{i}.") for i, value in enumerate(given)]
    for value, known, place in pairs:
        unknown = _unknown(value, known, place)
        if unknown is not None:
            return unknown
    return None
