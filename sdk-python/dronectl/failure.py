"""Errors as one sentence on stderr and a code at the end."""

import asyncio

import click
import pydantic

from dronemap import (
    AnswerLost,
    CommandError,
    DronemapError,
    NotConfigured,
    OutcomeUnknown,
    Problem,
    Unreachable,
    WaitedTooLong,
)

DONE = 0
REFUSED = 1
WRONG_USE = 2
NOT_KNOWN = 3
NO_SERVER = 4
INTERRUPTED = 130

_UNAUTHORIZED = 401


class NotSeen(DronemapError):
    """A drone was told to do something, and whether it does cannot be seen from here."""


class NotDone(DronemapError):
    """What was asked for came to an end other than the wanted one; the text says which."""


class BadFile(click.ClickException):
    """A file of the user that cannot be used; the text says where and why."""

    exit_code = WRONG_USE


class NotAnswered(click.ClickException):
    """A question that nobody is there to answer, or that was answered with no."""

    exit_code = REFUSED


def exit_code(error: BaseException) -> int:
    """What a program can tell from the end of dronectl."""
    if isinstance(error, KeyboardInterrupt | asyncio.CancelledError | click.Abort):
        return INTERRUPTED
    if isinstance(error, NotConfigured | Unreachable):
        return NO_SERVER
    if isinstance(error, AnswerLost | OutcomeUnknown | WaitedTooLong | NotSeen):
        return NOT_KNOWN
    if isinstance(error, click.ClickException):
        return error.exit_code
    if isinstance(error, pydantic.ValidationError):
        return WRONG_USE
    return REFUSED


def sentence(error: BaseException) -> str:
    """What went wrong and what to do, for people, with the code that docs/problems.md explains in brackets."""
    if isinstance(error, click.UsageError):
        path = error.ctx.command_path if error.ctx else "dronectl"
        return f"{_ended(error.format_message())} See: {path} --help"
    if isinstance(error, click.ClickException):
        return _ended(error.format_message())
    if isinstance(error, pydantic.ValidationError):
        return invalid(error)
    if isinstance(error, OSError):
        return f"{error.filename}: {error.strerror}." if error.filename else _ended(str(error))
    if isinstance(error, DronemapError):
        code = error.code if isinstance(error, Problem | CommandError) else None
        return " ".join(part for part in (_ended(str(error)), _advice(error), f"[{code}]" if code else "") if part)
    return (
        f"This is a fault of dronectl: {type(error).__name__}: {error}. With DRONECTL_DEBUG=1 it says where; report it."
    )


def invalid(error: pydantic.ValidationError) -> str:
    """Which member of a request is wrong, and why."""
    first = error.errors(include_url=False)[0]
    where = ".".join(str(part) for part in first["loc"])
    return _ended(f"{where}: {first['msg']}" if where else first["msg"])


def _advice(error: DronemapError) -> str:
    if isinstance(error, Unreachable):
        return "Check the address (dronectl config), and that the server runs."
    if isinstance(error, OutcomeUnknown | AnswerLost):
        return "Look at it before you repeat that (dronectl drones)."
    if isinstance(error, Problem) and error.status == _UNAUTHORIZED:
        return "Check where the access key comes from (dronectl config)."
    return ""


def _ended(text: str) -> str:
    text = text.strip()
    return text if text.endswith((".", "!", "?")) else f"{text}."
