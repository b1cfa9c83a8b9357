"""The six ways in which a command ends."""

from dataclasses import dataclass

from dronemap.contract.models import CommandView
from dronemap.errors import DronemapError


@dataclass(frozen=True)
class Succeeded:
    """The command was carried out."""

    command: str
    """Its id."""
    summary: str
    warnings: tuple[str, ...] = ()
    """What may be a slip of the hand, such as a far place."""


class CommandError(DronemapError):
    """A command that was not carried out, or of which that is not known.

    `by` is who decided it (gate: the server; vehicle), `reason` the sentence why, `code` the same for programs.
    """

    def __init__(self, command: str, summary: str, reason: str | None, *, by: str | None, code: str | None) -> None:
        super().__init__(f"{summary}: {reason}" if reason else f"{summary}: {self.words}.")
        self.command = command
        self.summary = summary
        self.reason = reason
        self.by = by
        self.code = code

    words = "it was not carried out"


class Refused(CommandError):
    """The server (by: gate) or the vehicle would not do it."""

    words = "it was refused"


class Failed(CommandError):
    """The vehicle tried, and could not."""

    words = "it failed"


class TimedOut(CommandError):
    """The vehicle did not do it in time."""

    words = "it was not done in time"


class Superseded(CommandError):
    """Another command, or another holder of control, took its place."""

    words = "another command took its place"


class OutcomeUnknown(CommandError):
    """Nobody knows whether it was carried out: look at the drone."""

    words = "whether it was carried out is not known"


Outcome = Succeeded | Refused | Failed | TimedOut | Superseded | OutcomeUnknown

_ERRORS: dict[str, type[Refused | Failed | TimedOut | Superseded | OutcomeUnknown]] = {
    "refused": Refused,
    "failed": Failed,
    "timedOut": TimedOut,
    "superseded": Superseded,
    "unknown": OutcomeUnknown,
}


def outcome_of(view: CommandView) -> Outcome | None:
    """None while it is under way; a result that this client has no name for is not known."""
    found = view.outcome
    if found is None:
        return None
    if found.result == "succeeded":
        return Succeeded(view.id, view.summary, tuple(view.warnings))
    error = _ERRORS.get(found.result, OutcomeUnknown)
    return error(view.id, view.summary, found.reason, by=found.by, code=found.code)
