"""Plans for several drones, and the mission runs that fly them, for programs that await."""

from collections.abc import AsyncIterator

from dronemap.contract.models import PlanAcceptRequest, PlanView, RunStartRequest, RunView
from dronemap.contract.operations import Operations
from dronemap.errors import DronemapError
from dronemap.stream import Stream
from dronemap.tracked import Tracked

_SEARCHED = ("finished", "cancelled", "failed")


def _is_searched(plan: PlanView) -> bool:
    return plan.state in _SEARCHED


def _is_over(run: RunView) -> bool:
    return run.state == "over"


class PlanFailed(DronemapError):
    """No plan was found; the text says why."""


class AsyncPlan:
    """A plan: searched for on the server, then accepted or flown as a run."""

    def __init__(self, view: PlanView, rest: Operations, stream: Stream) -> None:
        self.id = view.id
        self._rest = rest
        self._stream = stream
        self._tracked = Tracked(view, stream, "plan", lambda: rest.get_plan(view.id))

    @property
    def view(self) -> PlanView:
        return self._tracked.view

    def progress(self) -> AsyncIterator[PlanView]:
        """Each better plan, up to the last one."""
        return self._tracked.progress(_is_searched)

    async def wait(self, timeout: float | None = None) -> PlanView:
        """The plan as it was found; raises `PlanFailed` when there is none."""
        await self._tracked.until(_is_searched, timeout)
        view = await self._rest.get_plan(self.id)
        if view.state != "finished":
            raise PlanFailed(f"The plan is {view.state}{': ' + view.why if view.why else ''}.")
        return view

    async def accept(self, start: bool = False, wait: float | None = None) -> PlanView:
        """Brings each drone its mission; with `start` they are armed and started as well."""
        return await self._rest.accept_plan(self.id, PlanAcceptRequest(start=start), wait=wait)

    async def start_run(self, request: RunStartRequest | None = None) -> "AsyncRun":
        """Flies it as a mission run: watched, and planned anew when a drone fails."""
        asked = (request or RunStartRequest(plan=self.id)).model_copy(update={"plan": self.id})
        return AsyncRun(await self._rest.start_run(asked), self._rest, self._stream)

    async def stop(self) -> PlanView:
        """Ends the search; the best plan so far is kept."""
        return await self._rest.stop_plan(self.id)


class AsyncRun:
    """A plan that is being flown."""

    def __init__(self, view: RunView, rest: Operations, stream: Stream) -> None:
        self.id = view.id
        self._rest = rest
        self._tracked = Tracked(view, stream, "run", lambda: rest.get_run(view.id))

    @property
    def view(self) -> RunView:
        return self._tracked.view

    def progress(self) -> AsyncIterator[RunView]:
        return self._tracked.progress(_is_over)

    async def wait(self, timeout: float | None = None) -> RunView:
        """Returns when it is over; `view.end` says how, `view.counts` what was visited."""
        return await self._tracked.until(_is_over, timeout)

    async def pause(self) -> RunView:
        return await self._rest.pause_run(self.id)

    async def resume(self) -> RunView:
        return await self._rest.continue_run(self.id)

    async def stop(self) -> RunView:
        """All drones return home."""
        return await self._rest.stop_run(self.id)
