"""Control of a drone for the length of a block, for programs that await."""

import asyncio
from types import TracebackType
from typing import TYPE_CHECKING, Literal

from dronemap.contract.models import (
    ControlHeartbeatRequest,
    ControlTakeOverRequest,
    HoldCommand,
    LandCommand,
    ReturnToLaunchCommand,
)
from dronemap.contract.operations import Operations
from dronemap.errors import ControlLost, DronemapError, Problem, ServerLacks
from dronemap.stream import Stream

if TYPE_CHECKING:
    from dronemap.drone import AsyncDrone

#: return_home, land and hold: what it is told to do when the block is left while it is in the air; keep: nothing.
OnExit = Literal["return_home", "land", "hold", "keep"]

#: The server misses three of these before it calls a holder lost.
_HEARTBEAT_SECONDS = 2.0
_LONGEST_HEARTBEAT_SECONDS = 2.5
_FOR_NOW = (408, 429)
_COMMANDS = {"return_home": ReturnToLaunchCommand, "land": LandCommand, "hold": HoldCommand}


class AsyncControl:
    """Control of one drone, kept by heartbeats and given back at the end of the block.

    A program that ends without leaving the block, since it was killed or its machine is gone, is a lost holder: the
    server has the drone hold, and calls it home half a minute later unless somebody takes control. That is what
    becomes of a drone that is left in the air by `hold` and `keep` as well.
    """

    def __init__(
        self,
        drone: "AsyncDrone",
        rest: Operations,
        stream: Stream,
        on_exit: OnExit,
        take_over: str | None,
    ) -> None:
        self._drone = drone
        self._rest = rest
        self._stream = stream
        self._on_exit = on_exit
        self._take_over = take_over
        self._epoch: int | None = None
        self._lost: DronemapError | None = None
        self._beat: asyncio.Task[None] | None = None

    async def __aenter__(self) -> "AsyncDrone":
        if self._take_over is None:
            control = await self._rest.take_control(self._drone.id)
        else:
            reason = ControlTakeOverRequest(reason=self._take_over)
            control = await self._rest.take_over_control(self._drone.id, reason)
        self._epoch = control.epoch
        self._beat = asyncio.create_task(self._heartbeats())
        await self._stream.ready()
        return self._drone.under(self._held)

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        # Who cancels a program must not cancel what brings its drone to safety.
        await asyncio.shield(asyncio.ensure_future(self._leave()))

    async def _leave(self) -> None:
        try:
            if self._lost is None and await self._is_in_the_air():
                await self._come_down()
        finally:
            if self._beat is not None:
                self._beat.cancel()
            if self._lost is None:
                await self._rest.release_control(self._drone.id)

    async def _is_in_the_air(self) -> bool:
        """Asked for, since the stream may be cut; as it was told last where nobody answers."""
        try:
            state = await self._rest.get_drone(self._drone.id)
        except DronemapError:
            state = self._drone.state
        # What comes down already is left alone; of what nobody knows where it is, motors that turn count.
        return state.flight in ("takingOff", "inAir") or (state.flight is None and state.armed is True)

    async def _come_down(self) -> None:
        command = _COMMANDS.get(self._on_exit)
        if command is not None:
            await (await self._drone.under(self._held).give(command())).wait()

    def _held(self) -> int | None:
        if self._lost is not None:
            raise ControlLost(f"Control of {self._drone.name} has ended: {self._lost}") from self._lost
        return self._epoch

    async def _heartbeats(self) -> None:
        while self._lost is None:
            await asyncio.sleep(_HEARTBEAT_SECONDS)
            try:
                assert self._epoch is not None
                # One that hangs in a dead connection must not keep the next one from being sent.
                async with asyncio.timeout(_LONGEST_HEARTBEAT_SECONDS):
                    control = await self._rest.keep_control(self._drone.id, ControlHeartbeatRequest(epoch=self._epoch))
                # After a restart of the server it may be another one.
                self._epoch = control.epoch
            except Problem as e:
                # Without a judgement it is held still.
                if 400 <= e.status < 500 and e.status not in _FOR_NOW:
                    self._lost = e
            except ServerLacks as e:
                self._lost = e
            except (DronemapError, TimeoutError):
                # Nobody answered: it is held still, if the connection is back in time.
                continue
