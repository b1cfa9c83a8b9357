"""What happens to drones, for programs that do not await."""

from collections.abc import Iterator

from dronemap.contract.models import EventGap, NumberedEvent
from dronemap.events import AsyncEvents
from dronemap.sync.loop import LoopThread


class Events(Iterator[NumberedEvent | EventGap]):
    """An endless iterator over events, which goes on when the connection is cut (see `AsyncEvents`)."""

    def __init__(self, loop: LoopThread, awaited: AsyncEvents) -> None:
        self._loop = loop
        self._awaited = awaited

    @property
    def cursor(self) -> str:
        """Where to go on from, as `after`, in another program: what was read from there on may come once more."""
        return self._awaited.cursor

    def __next__(self) -> NumberedEvent | EventGap:
        return self._loop.run(self._awaited.__anext__())
