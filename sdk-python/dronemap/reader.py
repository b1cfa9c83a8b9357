"""Readers of the stream: each gets all that it asked for, as fast as it reads."""

import asyncio
from collections.abc import AsyncIterator, Callable, Hashable
from typing import Generic, TypeVar

from dronemap.errors import DronemapError

Item = TypeVar("Item")

#: So many changes wait for a reader that must not miss one.
_MOST_WAITING = 10_000
_BATCH_SECONDS = 0.02


class Reader(AsyncIterator[Item], Generic[Item]):
    """An iterator over what is put into it.

    Of what has the same `key`, the newest replaces one that waits; what has none waits in full, and a reader that
    lets too much of it wait is ended with an error. Any number of readers read the same, each at its own speed.
    """

    def __init__(self, key: Callable[[Item], Hashable] | None, on_close: Callable[["Reader[Item]"], None]) -> None:
        self._key = key
        self._on_close = on_close
        self._waiting: dict[Hashable, Item] = {}
        self._count = 0
        self._some = asyncio.Event()
        self._end: Exception | None = None
        self._batched = 0.0

    def put(self, item: Item) -> None:
        if self._key is None:
            self._count += 1
            self._waiting[self._count] = item
            if len(self._waiting) > _MOST_WAITING:
                self._waiting.clear()
                self.end(
                    DronemapError(f"More than {_MOST_WAITING} changes waited to be read: read faster, and begin anew.")
                )
        else:
            self._waiting[self._key(item)] = item
        self._some.set()

    def end(self, error: Exception | None = None) -> None:
        """Nothing more comes; what waits is read yet."""
        self._end = error or StopAsyncIteration()
        self._some.set()

    async def __anext__(self) -> Item:
        while not self._waiting:
            if self._end is not None:
                raise self._end
            self._some.clear()
            await self._some.wait()
        return self._waiting.pop(next(iter(self._waiting)))

    async def batch(self) -> list[Item]:
        """All that waits, at least one; `StopAsyncIteration` at the end.

        Who comes back at once waits for a moment, so that it is not woken for each of many.
        """
        loop = asyncio.get_running_loop()
        await asyncio.sleep(max(0.0, self._batched + _BATCH_SECONDS - loop.time()))
        first = await anext(self)
        self._batched = loop.time()
        others = list(self._waiting.values())
        self._waiting.clear()
        return [first, *others]

    def close(self) -> None:
        self._on_close(self)
        self.end()

    async def aclose(self) -> None:
        self.close()

    def __enter__(self) -> "Reader[Item]":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
