"""The thread on which everything that awaits runs, while the program itself does not."""

import asyncio
import threading
from collections.abc import AsyncIterator, Coroutine, Iterator
from concurrent.futures import CancelledError
from typing import Any, TypeVar

from dronemap.errors import DronemapError
from dronemap.reader import Reader

Result = TypeVar("Result")


class LoopThread:
    """An event loop on a thread of its own, until it is closed. Any thread may call it."""

    def __init__(self) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="dronemap", daemon=True)
        self._thread.start()
        self._closed = False

    def run(self, work: Coroutine[Any, Any, Result]) -> Result:
        """The work's result or error; who interrupts the program cancels the work."""
        if self._closed:
            work.close()
            raise DronemapError("This connection is closed.")
        future = asyncio.run_coroutine_threadsafe(work, self._loop)
        try:
            return future.result()
        except CancelledError as e:
            raise DronemapError("The connection was closed meanwhile.") from e
        except BaseException:
            future.cancel()
            raise

    def iterate(self, items: AsyncIterator[Result]) -> Iterator[Result]:
        """What the iterator gives, one after the other; it is closed when the program stops to read."""
        try:
            while True:
                try:
                    yield self.run(_next(items))
                except StopAsyncIteration:
                    return
        finally:
            if not self._closed:
                self.run(_close(items))

    def read(self, reader: Reader[Result]) -> Iterator[Result]:
        """The same for what many come of at a time: the threads change once for all that wait."""
        try:
            while True:
                try:
                    yield from self.run(reader.batch())
                except StopAsyncIteration:
                    return
        finally:
            if not self._closed:
                self.run(reader.aclose())

    def close(self) -> None:
        if not self._closed:
            self._closed = True
            self._loop.call_soon_threadsafe(self._loop.stop)
            self._thread.join()
            self._loop.close()


async def _next(items: AsyncIterator[Result]) -> Result:
    return await anext(items)


async def _close(items: AsyncIterator[Any]) -> None:
    close = getattr(items, "aclose", None)
    if close is not None:
        await close()
