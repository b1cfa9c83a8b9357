"""A drone, for programs that do not await."""

from collections.abc import Callable, Iterable, Iterator
from datetime import datetime
from types import TracebackType
from typing import Literal

from dronemap.command import AsyncCommand, Command
from dronemap.contract.models import CommandView, DroneView, MissionItemRequest
from dronemap.control import AsyncControl, OnExit
from dronemap.drone import AsyncDrone, Reference
from dronemap.outcome import Outcome, Succeeded
from dronemap.sync.loop import LoopThread
from dronemap.telemetry import TelemetryTable


class GivenCommand:
    """A command that was given, on its way to its one outcome."""

    def __init__(self, loop: LoopThread, command: AsyncCommand) -> None:
        self._loop = loop
        self._command = command

    @property
    def id(self) -> str:
        return self._command.id

    @property
    def view(self) -> CommandView:
        return self._command.view

    def outcome(self, timeout: float | None = None) -> Outcome:
        """How it ended; `WaitedTooLong` after `timeout` seconds, and then it is still under way."""
        return self._loop.run(self._command.outcome(timeout))

    def wait(self, timeout: float | None = None) -> Succeeded:
        """Returns when it was carried out, and raises a `CommandError` when it was not."""
        return self._loop.run(self._command.wait(timeout))


class Drone:
    """A drone of the server. Each command returns when it was carried out, and raises a `CommandError` when it was not.

    With `control()` nobody else commands it meanwhile; without, the first command takes control for a while.
    """

    def __init__(self, loop: LoopThread, awaited: AsyncDrone) -> None:
        self._loop = loop
        self._awaited = awaited

    @property
    def id(self) -> str:
        return self._awaited.id

    @property
    def name(self) -> str:
        return self._awaited.name

    @property
    def state(self) -> DroneView:
        """As it was told last."""
        return self._awaited.state

    def states(self, rate: float | None = None) -> Iterator[DroneView]:
        """The state now and whenever it changes, at most `rate` times a second; the newest wins."""
        return self._loop.iterate(self._awaited.states(rate))

    def wait_for(self, condition: Callable[[DroneView], bool], timeout: float | None = None) -> DroneView:
        """The first state that fulfils the condition; `WaitedTooLong` after `timeout` seconds."""
        return self._loop.run(self._awaited.wait_for(condition, timeout))

    def control(self, on_exit: OnExit = "return_home", *, take_over: str | None = None) -> "Control":
        """Control for the length of a `with`.

        Whoever leaves it while the drone is in the air has it return home first; `on_exit` says otherwise. `take_over`
        is the reason, for all to read, for which it is taken from somebody else (supervisors).
        """
        return Control(self._loop, self._awaited.control(on_exit, take_over=take_over))

    def give(self, command: Command) -> GivenCommand:
        """Gives any command, and returns while it is under way."""
        return GivenCommand(self._loop, self._loop.run(self._awaited.give(command)))

    def arm(self) -> None:
        self._loop.run(self._awaited.arm())

    def disarm(self) -> None:
        self._loop.run(self._awaited.disarm())

    def take_off(self, altitude: float, *, wait: bool = True) -> None:
        """Climbs to so many metres above home, and returns when it is there; at once with `wait=False`."""
        self._loop.run(self._awaited.take_off(altitude, wait=wait))

    def go_to(
        self,
        latitude: float,
        longitude: float,
        altitude: float,
        *,
        reference: Reference = "home",
        wait: bool = True,
    ) -> None:
        """Flies to a place, metres above home or above mean sea level (amsl), and returns when it is there."""
        self._loop.run(self._awaited.go_to(latitude, longitude, altitude, reference=reference, wait=wait))

    def land(self, *, wait: bool = True) -> None:
        """Lands where it is, and returns when it is down; at once with `wait=False`."""
        self._loop.run(self._awaited.land(wait=wait))

    def return_home(self, *, wait: bool = True) -> None:
        """Flies home and lands there, and returns when it is down; at once with `wait=False`."""
        self._loop.run(self._awaited.return_home(wait=wait))

    def hold(self) -> None:
        """Stops and stays where it is."""
        self._loop.run(self._awaited.hold())

    def change_speed(self, meters_per_second: float) -> None:
        """Goes on at that speed, until the mode changes: over the ground, or through the air for a plane."""
        self._loop.run(self._awaited.change_speed(meters_per_second))

    def set_mode(self, mode: str) -> None:
        self._loop.run(self._awaited.set_mode(mode))

    def take_picture(self) -> None:
        self._loop.run(self._awaited.take_picture())

    def upload_mission(self, items: Iterable[MissionItemRequest]) -> None:
        """Brings the mission to the vehicle, in place of the one it has."""
        self._loop.run(self._awaited.upload_mission(items))

    def start_mission(self, on_cloud_loss: Literal["continue", "rtl"] | None = None) -> None:
        self._loop.run(self._awaited.start_mission(on_cloud_loss))

    def fly_mission(self, items: Iterable[MissionItemRequest]) -> None:
        """Uploads the mission, arms, starts it, and returns when the vehicle has come to its end."""
        self._loop.run(self._awaited.fly_mission(items))

    def pause_mission(self) -> None:
        self._loop.run(self._awaited.pause_mission())

    def clear_mission(self) -> None:
        self._loop.run(self._awaited.clear_mission())

    def telemetry(
        self, since: datetime | None = None, until: datetime | None = None, most: int = 5000
    ) -> TelemetryTable:
        """The states that were recorded, as a table; of more than `most` so many, evenly over the time.

        Without `since` and `until` it is the last hour.
        """
        return self._loop.run(self._awaited.telemetry(since, until, most))


class Control:
    """Control of one drone, kept by heartbeats and given back at the end of the block (see `AsyncControl`)."""

    def __init__(self, loop: LoopThread, awaited: AsyncControl) -> None:
        self._loop = loop
        self._awaited = awaited

    def __enter__(self) -> Drone:
        return Drone(self._loop, self._loop.run(self._awaited.__aenter__()))

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._loop.run(self._awaited.__aexit__(kind, error, trace))
