"""A drone, for programs that await."""

import asyncio
from collections.abc import AsyncGenerator, Callable, Iterable
from datetime import UTC, datetime
from typing import Literal

from dronemap.arrival import arrived, at_height, at_place, mission_flown, on_ground
from dronemap.command import AsyncCommand, Command, CommandGiver
from dronemap.contract.models import (
    ArmCommand,
    ChangeSpeedCommand,
    ClearMissionCommand,
    DisarmCommand,
    DroneView,
    GoToCommand,
    HoldCommand,
    LandCommand,
    MissionItemRequest,
    PauseMissionCommand,
    ReturnToLaunchCommand,
    SetModeCommand,
    StartMissionCommand,
    TakeOffCommand,
    TakePictureCommand,
    UploadMissionCommand,
)
from dronemap.contract.operations import Operations
from dronemap.control import AsyncControl, OnExit
from dronemap.errors import WaitedTooLong
from dronemap.stream import Stream
from dronemap.telemetry import TelemetryTable

State = DroneView
Condition = Callable[[DroneView], bool]
Reference = Literal["home", "amsl"]


class AsyncDrone:
    """A drone of the server. Each command returns when it was carried out, and raises a `CommandError` when it was not.

    With `control()` nobody else commands it meanwhile; without, the first command takes control for a while.
    """

    def __init__(self, known: DroneView, rest: Operations, stream: Stream) -> None:
        self._known = known
        self._rest = rest
        self._stream = stream
        self._commands = CommandGiver(rest, stream)
        self._epoch: Callable[[], int | None] = lambda: None

    @property
    def id(self) -> str:
        return self._known.id

    @property
    def name(self) -> str:
        return self.state.name

    @property
    def state(self) -> DroneView:
        """As it was told last."""
        change = self._stream.drones.get(self._known.id)
        if change is not None:
            self._known = change.state
        return self._known

    async def states(self, rate: float | None = None) -> AsyncGenerator[DroneView]:
        """The state now and whenever it changes, at most `rate` times a second; the newest wins."""
        pause = 0.0 if rate is None else 1 / rate
        with self._stream.changes() as changes:
            async for change in changes:
                if change.id == self.id:
                    yield change.state
                    if pause:
                        await asyncio.sleep(pause)

    async def wait_for(self, condition: Condition, timeout: float | None = None) -> DroneView:
        """The first state that fulfils the condition; `WaitedTooLong` after `timeout` seconds."""
        try:
            async with asyncio.timeout(timeout):
                async for state in self.states():
                    if condition(state):
                        return state
        except TimeoutError as e:
            raise WaitedTooLong(f"{self.name}: what was waited for has not come true within {timeout} s.") from e
        raise WaitedTooLong(f"{self.name}: the stream ended before what was waited for came true.")

    def control(self, on_exit: OnExit = "return_home", *, take_over: str | None = None) -> AsyncControl:
        """Control for the length of an `async with`.

        Whoever leaves it while the drone is in the air has it return home first; `on_exit` says otherwise. `take_over`
        is the reason, for all to read, for which it is taken from somebody else (supervisors).
        """
        return AsyncControl(self, self._rest, self._stream, on_exit, take_over)

    async def give(self, command: Command) -> AsyncCommand:
        """Gives any command, and returns while it is under way."""
        return await self._commands.give(self.id, command, self._epoch())

    async def arm(self) -> None:
        await self._done(ArmCommand())

    async def disarm(self) -> None:
        await self._done(DisarmCommand())

    async def take_off(self, altitude: float, *, wait: bool = True) -> None:
        """Climbs to so many metres above home, and returns when it is there; at once with `wait=False`."""
        await self._done(TakeOffCommand(altitude=altitude))
        if wait:
            await self._arrived(at_height(altitude), f"{altitude} m above home")

    async def go_to(
        self,
        latitude: float,
        longitude: float,
        altitude: float,
        *,
        reference: Reference = "home",
        wait: bool = True,
    ) -> None:
        """Flies to a place, metres above home or above mean sea level (amsl), and returns when it is there."""
        await self._done(
            GoToCommand(latitude=latitude, longitude=longitude, altitude=altitude, altitude_reference=reference)
        )
        if wait:
            await self._arrived(at_place(latitude, longitude, altitude, reference), f"at {latitude}, {longitude}")

    async def land(self, *, wait: bool = True) -> None:
        """Lands where it is, and returns when it is down; at once with `wait=False`."""
        await self._done(LandCommand())
        if wait:
            await self._arrived(on_ground, "on the ground")

    async def return_home(self, *, wait: bool = True) -> None:
        """Flies home and lands there, and returns when it is down; at once with `wait=False`."""
        await self._done(ReturnToLaunchCommand())
        if wait:
            await self._arrived(on_ground, "on the ground")

    async def hold(self) -> None:
        """Stops and stays where it is."""
        await self._done(HoldCommand())

    async def change_speed(self, meters_per_second: float) -> None:
        """Goes on at that speed, until the mode changes: over the ground, or through the air for a plane."""
        await self._done(ChangeSpeedCommand(meters_per_second=meters_per_second))

    async def set_mode(self, mode: str) -> None:
        await self._done(SetModeCommand(mode=mode))

    async def take_picture(self) -> None:
        await self._done(TakePictureCommand())

    async def upload_mission(self, items: Iterable[MissionItemRequest]) -> None:
        """Brings the mission to the vehicle, in place of the one it has."""
        await self._done(UploadMissionCommand(items=list(items)))

    async def start_mission(self, on_cloud_loss: Literal["continue", "rtl"] | None = None) -> None:
        await self._done(StartMissionCommand(on_cloud_loss=on_cloud_loss))

    async def fly_mission(self, items: Iterable[MissionItemRequest]) -> None:
        """Uploads the mission, arms, starts it, and returns when the vehicle has come to its end."""
        await self.upload_mission(items)
        if not self.state.armed:
            await self.arm()
        await self.start_mission()
        await self._arrived(mission_flown(), "at the end of its mission")

    async def pause_mission(self) -> None:
        await self._done(PauseMissionCommand())

    async def clear_mission(self) -> None:
        await self._done(ClearMissionCommand())

    async def telemetry(
        self, since: datetime | None = None, until: datetime | None = None, most: int = 5000
    ) -> TelemetryTable:
        """The states that were recorded, as a table; of more than `most` so many, evenly over the time.

        Without `since` and `until` it is the last hour.
        """
        points = await self._rest.list_drone_telemetry_points(
            self.id, from_=_iso(since), until=_iso(until), most=str(most)
        )
        return TelemetryTable(points)

    async def _arrived(self, reached: Condition, aim: str) -> None:
        states = self.states()
        try:
            await arrived(states, reached, aim)
        finally:
            await states.aclose()

    async def _done(self, command: Command) -> None:
        action = self.state.actions.get(command.type)
        if action is not None and action.mode is not None:
            # The vehicle takes it in another mode only, such as arming after a return.
            await (await self.give(SetModeCommand(mode=action.mode))).wait()
        await (await self.give(command)).wait()

    def under(self, epoch: Callable[[], int | None]) -> "AsyncDrone":
        """The same drone, whose commands count under that control only."""
        drone = AsyncDrone(self._known, self._rest, self._stream)
        drone._epoch = epoch
        return drone


def _iso(time: datetime | None) -> str | None:
    """In UTC; a time without a zone is meant as this machine has it."""
    return None if time is None else time.astimezone(UTC).isoformat()
