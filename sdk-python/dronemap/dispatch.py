"""A drone of the pool that is sent to a place, for programs that await."""

from collections.abc import AsyncIterator

from dronemap.contract.models import DispatchView
from dronemap.contract.operations import Operations
from dronemap.errors import DronemapError
from dronemap.stream import Stream
from dronemap.tracked import Tracked


class NotHere(DronemapError):
    """No drone came; the message says why."""


def _is_here(dispatch: DispatchView) -> bool:
    return dispatch.state == "here" or _is_over(dispatch)


def _is_over(dispatch: DispatchView) -> bool:
    return dispatch.state in ("returning", "over")


def _is_down(dispatch: DispatchView) -> bool:
    return dispatch.state == "over"


class AsyncDispatch:
    """A drone that was sent to a place: when it is there, whoever asked has control of it.

    From then on it is as with any drone in hand: `server.drone(view.drone).control()` keeps it, and it holds and flies
    home some 20 s after it came when nobody does.
    """

    def __init__(self, view: DispatchView, rest: Operations, stream: Stream) -> None:
        self.id = view.id
        self._rest = rest
        self._tracked = Tracked(view, stream, "dispatch", lambda: rest.get_dispatch(view.id))

    @property
    def view(self) -> DispatchView:
        return self._tracked.view

    def progress(self) -> AsyncIterator[DispatchView]:
        """As it stands now, and whenever that changes, up to when the drone is here, or none comes any more."""
        return self._tracked.progress(_is_here)

    async def arrival(self, timeout: float | None = None) -> str:
        """Returns the id of the drone that is here; raises `NotHere` when none comes."""
        view = await self._tracked.until(_is_here, timeout)
        if view.state != "here" or view.drone is None:
            raise NotHere(view.end or "No drone came.")
        return view.drone

    async def wait(self, timeout: float | None = None) -> DispatchView:
        """Returns when it is over, and what flew for it is down or in somebody's hand; `view.end` says how."""
        return await self._tracked.until(_is_down, timeout)

    async def cancel(self) -> DispatchView:
        """Calls it off: the drone flies home, from wherever it is."""
        return await self._rest.cancel_dispatch(self.id)
