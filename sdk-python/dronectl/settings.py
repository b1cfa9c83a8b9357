"""What the options of all commands say, and the session with the server that comes of it."""

import asyncio
import stat
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol, TypeVar

import click

from dronectl.output import Output
from dronemap import AsyncDronemap, DronemapError, NoSuchDrone, NotConfigured, WaitedTooLong, models
from dronemap.client import PATIENCE_SECONDS
from dronemap.drone import AsyncDrone
from dronemap.transport import Transport

_OTHERS_MAY_READ = 0o077
_STREAM_SECONDS = 5.0


@dataclass
class Settings:
    """The options of all commands. `timeout` is in seconds; `transport` is what tests put in place of a server."""

    url: str | None = None
    key_file: Path | None = None
    profile: str | None = None
    as_json: bool = False
    timeout: float | None = None
    transport: Transport | None = None

    def key(self) -> str | None:
        """The access key of --key-file; None: whatever the environment and the file of profiles say."""
        if self.key_file is None:
            return None
        try:
            mode = self.key_file.stat().st_mode
            if stat.S_ISREG(mode) and mode & _OTHERS_MAY_READ:
                raise NotConfigured(f"Others may read {self.key_file}, which holds an access key: chmod 600 it.")
            key = self.key_file.read_text().strip()
        except (OSError, UnicodeDecodeError) as e:
            raise NotConfigured(f"The file of the access key cannot be read: {e}") from e
        if not key:
            raise NotConfigured(f"There is no access key in {self.key_file}: it is empty.")
        return key

    def connect(self, patience: float = PATIENCE_SECONDS) -> AsyncDronemap:
        """`patience` seconds, or those of --timeout if they are less, are tried again for what fails."""
        patience = patience if self.timeout is None else min(patience, self.timeout)
        key = None if self.transport is not None else self.key()
        return AsyncDronemap.connect(self.url, key, profile=self.profile, transport=self.transport, patience=patience)

    def run(self, work: Callable[["Session"], Awaitable[None]]) -> None:
        """Does it with a connection to the server, which is closed at the end; Ctrl-C cancels it."""
        asyncio.run(self._within(work))

    async def _within(self, work: Callable[["Session"], Awaitable[None]]) -> None:
        async with self.connect() as server:
            session = Session(server, Output(self.as_json))
            task = asyncio.ensure_future(work(session))
            try:
                done, _ = await asyncio.wait({task}, timeout=self.timeout)
            except asyncio.CancelledError:
                session.interrupted = True
                await _ended(task)
                raise
            if not done:
                await _ended(task)
                if task.cancelled():
                    raise WaitedTooLong(f"It is not over after {self.timeout:g} s; what was asked for goes on.")
            task.result()


@dataclass
class Session:
    """A server and where to print, for the length of one command."""

    server: AsyncDronemap
    output: Output
    interrupted: bool = field(default=False)
    """By the user, in contrast to --timeout."""

    async def view(self, name: str | None) -> models.DroneView:
        """The drone of that name or id; without one the only drone there is."""
        return chosen((await self.server.rest.list_drones()).drones, name)

    async def id(self, name: str | None) -> str:
        return (await self.view(name)).id

    async def drone(self, name: str | None) -> AsyncDrone:
        """The same to command and watch."""
        drone = AsyncDrone(await self.view(name), self.server.rest, self.server.stream)
        await self.ready()
        return drone

    async def ready(self) -> None:
        """Returns when the stream is there; one that does not come keeps no command back."""
        try:
            async with asyncio.timeout(_STREAM_SECONDS):
                await self.server.stream.ready()
        except TimeoutError:
            self.output.note("The server's stream cannot be reached: what the drone does cannot be seen.")


def chosen(drones: list[models.DroneView], name: str | None) -> models.DroneView:
    """By id, else by name; never one of several. Replayed drones count where nothing else fits."""
    real = [drone for drone in drones if not drone.replay]
    if name is not None:
        return one("drone", real if any(name in (drone.id, drone.name) for drone in real) else drones, name)
    drones = real or drones
    if not drones:
        raise NoSuchDrone("There is no drone.")
    if len(drones) > 1:
        names = ", ".join(sorted(drone.name for drone in drones))
        raise click.UsageError(f"There are {len(drones)} drones: {names}. Say which with --drone.", _context())
    return drones[0]


class Named(Protocol):
    """Whatever has an id and a name at the server."""

    @property
    def id(self) -> str | None: ...

    @property
    def name(self) -> str: ...


Thing = TypeVar("Thing", bound=Named)


def one(kind: str, things: Sequence[Thing], wanted: str) -> Thing:
    """The thing of that id, else the only one of that name."""
    fitting = [thing for thing in things if thing.id == wanted] or [thing for thing in things if thing.name == wanted]
    if not fitting:
        names = ", ".join(sorted(thing.name for thing in things)) or "none"
        error = NoSuchDrone if kind == "drone" else DronemapError
        raise error(f"There is no {kind} '{wanted}'; there are: {names}.")
    if len(fitting) > 1:
        ids = ", ".join(thing.id or "" for thing in fitting)
        raise click.UsageError(f"Several have the name '{wanted}': take the id of one ({ids}).", _context())
    return fitting[0]


def _context() -> click.Context | None:
    return click.get_current_context(silent=True)


async def _ended(task: "asyncio.Future[None]") -> None:
    task.cancel()
    await asyncio.wait({task})
