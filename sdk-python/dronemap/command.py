"""Giving a command, and learning how it ends."""

import asyncio
import secrets

from dronemap.contract.models import (
    ArmCommand,
    ChangeSpeedCommand,
    ClearMissionCommand,
    CommandView,
    DisarmCommand,
    EmergencyStopCommand,
    GoToCommand,
    GoToLocalCommand,
    HoldCommand,
    LandCommand,
    PauseMissionCommand,
    ReadHomeCommand,
    ReadLogsCommand,
    ReadMapCommand,
    ReadParametersCommand,
    ReturnToLaunchCommand,
    SetHomeCommand,
    SetModeCommand,
    SetParametersCommand,
    SetRelayCommand,
    StartMissionCommand,
    TakeOffCommand,
    TakePictureCommand,
    TurnCommand,
    UploadMissionCommand,
)
from dronemap.contract.operations import Operations
from dronemap.errors import AnswerLost, DronemapError, Problem, WaitedTooLong
from dronemap.outcome import Outcome, OutcomeUnknown, Refused, Succeeded, outcome_of
from dronemap.reader import Reader
from dronemap.stream import Message, Stream

Command = (
    ArmCommand
    | ChangeSpeedCommand
    | ClearMissionCommand
    | DisarmCommand
    | EmergencyStopCommand
    | GoToCommand
    | GoToLocalCommand
    | HoldCommand
    | LandCommand
    | PauseMissionCommand
    | ReadHomeCommand
    | ReadLogsCommand
    | ReadMapCommand
    | ReadParametersCommand
    | ReturnToLaunchCommand
    | SetHomeCommand
    | SetModeCommand
    | SetParametersCommand
    | SetRelayCommand
    | StartMissionCommand
    | TakeOffCommand
    | TakePictureCommand
    | TurnCommand
    | UploadMissionCommand
)

_COMMANDS = frozenset({"command"})
#: What the stream may have said while it was cut is asked for.
_LOOK_SECONDS = 2.0


class AsyncCommand:
    """A command that was given, on its way to its one outcome."""

    def __init__(self, view: CommandView, rest: Operations, reader: Reader[Message]) -> None:
        self.view = view
        self._rest = rest
        self._outcome = outcome_of(view)
        self._reader = reader

    @property
    def id(self) -> str:
        return self.view.id

    async def outcome(self, timeout: float | None = None) -> Outcome:
        """How it ended; `WaitedTooLong` after `timeout` seconds, and then it is still under way."""
        try:
            async with asyncio.timeout(timeout):
                while self._outcome is None:
                    await self._look()
        except TimeoutError as e:
            raise WaitedTooLong(f"{self.view.summary}: it is still under way after {timeout} s.") from e
        self._reader.close()
        return self._outcome

    async def wait(self, timeout: float | None = None) -> Succeeded:
        """Returns when it was carried out, and raises a `CommandError` when it was not."""
        outcome = await self.outcome(timeout)
        if not isinstance(outcome, Succeeded):
            raise outcome
        return outcome

    async def _look(self) -> None:
        try:
            async with asyncio.timeout(_LOOK_SECONDS):
                async for message in self._reader:
                    if message["command"]["id"] == self.id:
                        self._take(CommandView.model_validate(message["command"]))
                        return
        except TimeoutError:
            pass
        self._take(await self._rest.get_command(self.id))

    def _take(self, view: CommandView) -> None:
        self.view = view
        self._outcome = outcome_of(view)


class CommandGiver:
    """Gives commands to drones; each has an id of its own, so that it acts once however often it is sent."""

    def __init__(self, rest: Operations, stream: Stream) -> None:
        self._rest = rest
        self._stream = stream

    async def give(self, drone: str, command: Command, epoch: int | None = None) -> AsyncCommand:
        """Raises `Refused` when the server does not let it pass to the vehicle."""
        own = command.model_copy(
            update={"id": command.id or secrets.token_urlsafe(12), "epoch": command.epoch or epoch}
        )
        # From now on: the outcome may be told before the answer has come.
        reader = self._stream.messages(_COMMANDS, None)
        try:
            return AsyncCommand(await self._given(drone, own), self._rest, reader)
        except BaseException:
            reader.close()
            raise

    async def _given(self, drone: str, own: Command) -> CommandView:
        try:
            return await self._rest.give_command(drone, own)
        except Problem as e:
            if e.command_id is None:
                raise
            raise Refused(e.command_id, own.type, str(e), by="gate", code=e.code) from e
        except AnswerLost as e:
            assert own.id is not None
            return await self._known(own.id, own.type, e)

    async def _known(self, command: str, kind: str, lost: AnswerLost) -> CommandView:
        try:
            return await self._rest.get_command(command)
        except DronemapError:
            raise OutcomeUnknown(command, kind, str(lost), by=None, code=None) from lost
