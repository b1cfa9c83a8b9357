"""What happens to drones, in order and without a loss that is not told, for programs that await."""

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Iterable

from dronemap.contract.models import EventGap, FollowedEvents, NumberedEvent
from dronemap.contract.operations import Operations
from dronemap.errors import AnswerLost, Problem, Unreachable

#: From the oldest event that the server keeps.
FIRST = "first"
_WAIT_SECONDS = 30.0
_AT_ONCE = 1000
_PAUSE_SECONDS = 1.0
_FOR_NOW = (429, 503)


class AsyncEvents(AsyncIterator[NumberedEvent | EventGap]):
    """An endless iterator over events, which goes on when the connection is cut or the server restarted.

    Where the server holds events no more, or never got to write them down, an `EventGap` stands in their place.
    Any number of iterators read the same events, each for itself.
    """

    def __init__(self, rest: Operations, after: str, drones: Iterable[str]) -> None:
        self._rest = rest
        self._next = after
        self._drones = ",".join(drones) or None
        self._waiting: deque[NumberedEvent | EventGap] = deque()
        self.cursor = after
        """Where to go on from, as `after`, in another program: what was read from there on may come once more."""

    @classmethod
    async def begin(cls, rest: Operations, after: str | None, drones: Iterable[str]) -> "AsyncEvents":
        """From now on, or from a cursor, or from the FIRST that is kept."""
        ids = list(drones)
        if after is None:
            after = (await rest.follow_events(drones=",".join(ids) or None)).next
        return cls(rest, after, ids)

    async def __anext__(self) -> NumberedEvent | EventGap:
        while not self._waiting:
            self.cursor = self._next
            await self._fetch()
        return self._waiting.popleft()

    async def _fetch(self) -> None:
        try:
            page = await self._rest.follow_events(
                after=self._next, limit=_AT_ONCE, wait=_WAIT_SECONDS, drones=self._drones
            )
        except (Unreachable, AnswerLost):
            await asyncio.sleep(_PAUSE_SECONDS)
            return
        except Problem as e:
            if e.status not in _FOR_NOW:
                raise
            await asyncio.sleep(e.retry_after_seconds or _PAUSE_SECONDS)
            return
        self._waiting.extend(in_order(page))
        self._next = page.next


def in_order(page: FollowedEvents) -> list[NumberedEvent | EventGap]:
    """Events with each gap before those that come after it."""
    told: list[tuple[int, int, NumberedEvent | EventGap]] = []
    told += [(gap.after, 1, gap) for gap in page.gaps]
    told += [(event.number, 0, event) for event in page.events]
    return [item for _, _, item in sorted(told, key=lambda each: each[:2])]
