"""Several drones that come home, or land, together, for programs that await."""

from collections.abc import AsyncIterator

from dronemap.contract.models import RecoveryView
from dronemap.contract.operations import Operations
from dronemap.stream import Stream
from dronemap.tracked import Tracked


def _is_over(recovery: RecoveryView) -> bool:
    return recovery.state == "over"


class AsyncRecovery:
    """Drones that come home, or land, each in its turn; `view.drones` has the outcome of each."""

    def __init__(self, view: RecoveryView, rest: Operations, stream: Stream) -> None:
        self.id = view.id
        self._rest = rest
        self._tracked = Tracked(view, stream, "recovery", lambda: rest.get_recovery(view.id))

    @property
    def view(self) -> RecoveryView:
        return self._tracked.view

    def progress(self) -> AsyncIterator[RecoveryView]:
        """As it stands now, and whenever that changes, up to when it is over."""
        return self._tracked.progress(_is_over)

    async def wait(self, timeout: float | None = None) -> RecoveryView:
        """Returns when it is over; `view.end` says how, and each of `view.drones` what became of it."""
        return await self._tracked.until(_is_over, timeout)

    async def cancel(self) -> RecoveryView:
        """Calls it off: its drones hold, and control of them goes over to whoever asked."""
        return await self._rest.cancel_recovery(self.id)
