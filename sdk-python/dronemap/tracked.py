"""What goes on for a while on the server, watched until it is over: plans, mission runs, follows."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from typing import Generic, TypeVar

from dronemap.contract.model import Model
from dronemap.errors import WaitedTooLong
from dronemap.stream import Message, Stream

View = TypeVar("View", bound=Model)
#: What the stream may have said while it was cut is asked for.
_LOOK_SECONDS = 5.0


class Tracked(Generic[View]):
    """One such thing: `view` is how it stood when it was told of last."""

    def __init__(self, view: View, stream: Stream, topic: str, read: Callable[[], Awaitable[View]]) -> None:
        self.view = view
        self._stream = stream
        self._topic = topic
        self._read = read

    async def progress(self, is_over: Callable[[View], bool]) -> AsyncIterator[View]:
        """As it stands now, and whenever that changes, up to how it stood when it was over."""
        with self._stream.messages(frozenset({self._topic}), self._id_of) as messages:
            self.view = await self._read()
            yield self.view
            while not is_over(self.view):
                try:
                    async with asyncio.timeout(_LOOK_SECONDS):
                        message = await anext(messages)
                except TimeoutError:
                    self.view = await self._read()
                else:
                    if self._id_of(message) != self._id():
                        continue
                    self.view = type(self.view).model_validate(message[self._topic])
                yield self.view

    async def until(self, is_over: Callable[[View], bool], timeout: float | None) -> View:
        try:
            async with asyncio.timeout(timeout):
                async for _ in self.progress(is_over):
                    pass
        except TimeoutError as e:
            raise WaitedTooLong(f"The {self._topic} {self._id()} is not over after {timeout} s.") from e
        return self.view

    def _id_of(self, message: Message) -> str:
        return str(message[self._topic]["id"])

    def _id(self) -> str:
        return str(self.view.model_dump(include={"id"})["id"])
