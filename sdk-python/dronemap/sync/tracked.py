"""What goes on for a while on the server, for programs that do not await."""

from collections.abc import Iterator
from datetime import datetime
from typing import Literal

from dronemap.contract.models import (
    DispatchView,
    FollowReceipt,
    FollowView,
    PlanView,
    RecoveryView,
    RunStartRequest,
    RunView,
    VirtualDroneView,
)
from dronemap.dispatch import AsyncDispatch
from dronemap.follow import AsyncFollow
from dronemap.plan import AsyncPlan, AsyncRun
from dronemap.recovery import AsyncRecovery
from dronemap.sync.loop import LoopThread
from dronemap.virtual import AsyncVirtualDrone


class Plan:
    """A plan: searched for on the server, then accepted or flown as a run."""

    def __init__(self, loop: LoopThread, awaited: AsyncPlan) -> None:
        self._loop = loop
        self._awaited = awaited
        self.id = awaited.id

    @property
    def view(self) -> PlanView:
        return self._awaited.view

    def progress(self) -> Iterator[PlanView]:
        """Each better plan, up to the last one."""
        return self._loop.iterate(self._awaited.progress())

    def wait(self, timeout: float | None = None) -> PlanView:
        """The plan as it was found; raises `PlanFailed` when there is none."""
        return self._loop.run(self._awaited.wait(timeout))

    def accept(self, start: bool = False, wait: float | None = None) -> PlanView:
        """Brings each drone its mission; with `start` they are armed and started as well."""
        return self._loop.run(self._awaited.accept(start, wait))

    def start_run(self, request: RunStartRequest | None = None) -> "Run":
        """Flies it as a mission run: watched, and planned anew when a drone fails."""
        return Run(self._loop, self._loop.run(self._awaited.start_run(request)))

    def stop(self) -> PlanView:
        """Ends the search; the best plan so far is kept."""
        return self._loop.run(self._awaited.stop())


class Run:
    """A plan that is being flown."""

    def __init__(self, loop: LoopThread, awaited: AsyncRun) -> None:
        self._loop = loop
        self._awaited = awaited
        self.id = awaited.id

    @property
    def view(self) -> RunView:
        return self._awaited.view

    def progress(self) -> Iterator[RunView]:
        return self._loop.iterate(self._awaited.progress())

    def wait(self, timeout: float | None = None) -> RunView:
        """Returns when it is over; `view.end` says how, `view.counts` what was visited."""
        return self._loop.run(self._awaited.wait(timeout))

    def pause(self) -> RunView:
        return self._loop.run(self._awaited.pause())

    def resume(self) -> RunView:
        return self._loop.run(self._awaited.resume())

    def stop(self) -> RunView:
        """All drones return home."""
        return self._loop.run(self._awaited.stop())


class Follow:
    """A follow: the drone keeps its place beside the positions that are reported (see `AsyncFollow`)."""

    def __init__(self, loop: LoopThread, awaited: AsyncFollow) -> None:
        self._loop = loop
        self._awaited = awaited
        self.id = awaited.id

    @property
    def view(self) -> FollowView:
        return self._awaited.view

    def progress(self) -> Iterator[FollowView]:
        return self._loop.iterate(self._awaited.progress())

    def wait(self, timeout: float | None = None) -> FollowView:
        """Returns when it is over; `view.end` says how."""
        return self._loop.run(self._awaited.wait(timeout))

    def start(self) -> FollowView:
        """The drone takes off and comes."""
        return self._loop.run(self._awaited.start())

    def report(
        self,
        latitude: float,
        longitude: float,
        *,
        accuracy: float | None = None,
        speed: float | None = None,
        course: float | None = None,
        at: datetime | None = None,
    ) -> FollowReceipt:
        """Tells where the phone is: degrees, metres, m/s, degrees from true north."""
        return self._loop.run(
            self._awaited.report(latitude, longitude, accuracy=accuracy, speed=speed, course=course, at=at)
        )

    def pause(self) -> FollowView:
        """The drone holds."""
        return self._loop.run(self._awaited.pause())

    def resume(self) -> FollowView:
        return self._loop.run(self._awaited.resume())

    def stop(self) -> FollowView:
        """The drone returns home."""
        return self._loop.run(self._awaited.stop())

    def cancel(self) -> FollowView:
        """Gives the drone back before it has taken off."""
        return self._loop.run(self._awaited.cancel())


class Dispatch:
    """A drone that was sent to a place (see `AsyncDispatch`)."""

    def __init__(self, loop: LoopThread, awaited: AsyncDispatch) -> None:
        self._loop = loop
        self._awaited = awaited
        self.id = awaited.id

    @property
    def view(self) -> DispatchView:
        return self._awaited.view

    def progress(self) -> Iterator[DispatchView]:
        """As it stands now, and whenever that changes, up to when the drone is here, or none comes any more."""
        return self._loop.iterate(self._awaited.progress())

    def arrival(self, timeout: float | None = None) -> str:
        """Returns the id of the drone that is here; raises `NotHere` when none comes."""
        return self._loop.run(self._awaited.arrival(timeout))

    def wait(self, timeout: float | None = None) -> DispatchView:
        """Returns when it is over; `view.end` says how."""
        return self._loop.run(self._awaited.wait(timeout))

    def cancel(self) -> DispatchView:
        """Calls it off: the drone flies home, from wherever it is."""
        return self._loop.run(self._awaited.cancel())


class Recovery:
    """Drones that come home, or land, together (see `AsyncRecovery`)."""

    def __init__(self, loop: LoopThread, awaited: AsyncRecovery) -> None:
        self._loop = loop
        self._awaited = awaited
        self.id = awaited.id

    @property
    def view(self) -> RecoveryView:
        return self._awaited.view

    def progress(self) -> Iterator[RecoveryView]:
        """As it stands now, and whenever that changes, up to when it is over."""
        return self._loop.iterate(self._awaited.progress())

    def wait(self, timeout: float | None = None) -> RecoveryView:
        """Returns when it is over; `view.end` says how."""
        return self._loop.run(self._awaited.wait(timeout))

    def cancel(self) -> RecoveryView:
        """Calls it off: its drones hold, and control of them goes over to whoever asked."""
        return self._loop.run(self._awaited.cancel())


class VirtualDrone:
    """A virtual drone: it is bound to a drone of the warehouse when its mission is started."""

    def __init__(self, loop: LoopThread, awaited: AsyncVirtualDrone) -> None:
        self._loop = loop
        self._awaited = awaited
        self.id = awaited.id

    @property
    def view(self) -> VirtualDroneView:
        return self._awaited.view

    def progress(self) -> Iterator[VirtualDroneView]:
        """Its mission as it goes on, up to its end."""
        return self._loop.iterate(self._awaited.progress())

    def start(self, on_cloud_loss: Literal["continue", "rtl"] | None = None) -> VirtualDroneView:
        return self._loop.run(self._awaited.start(on_cloud_loss))

    def wait(self, timeout: float | None = None) -> VirtualDroneView:
        """Returns when its mission has come to its end; raises `MissionFailed` when it has not."""
        return self._loop.run(self._awaited.wait(timeout))

    def stop(self) -> VirtualDroneView:
        return self._loop.run(self._awaited.stop())

    def resume(self) -> VirtualDroneView:
        return self._loop.run(self._awaited.resume())

    def remove(self) -> None:
        self._loop.run(self._awaited.remove())
