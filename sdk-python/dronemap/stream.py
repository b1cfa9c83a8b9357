"""The stream of a server: kept open, opened anew when it is cut, and read by many."""

import asyncio
import json
import random
from collections.abc import Awaitable, Callable, Hashable
from typing import Any

from pydantic.alias_generators import to_camel
from pydantic_core import from_json

from dronemap.contract.models import DroneView
from dronemap.errors import DronemapError, Problem, ServerLacks
from dronemap.reader import Reader
from dronemap.transport import StreamClosed, StreamSocket, Transport

Message = dict[str, Any]
#: The server says something once a second.
_SILENT_SECONDS = 5.0
_FIRST_PAUSE = 0.3
_LONGEST_PAUSE = 3.0


class StateReader:
    """Reads the states of one drone; parts that are as they were the last time are not read again."""

    _NAMES = {field.alias or to_camel(name): name for name, field in DroneView.model_fields.items()}

    def __init__(self) -> None:
        # One value, since several threads may read.
        self._last: tuple[Message, DroneView] | None = None

    def read(self, members: Message) -> DroneView:
        state = DroneView.model_validate(members | self._unchanged(members))
        self._last = (members, state)
        return state

    def _unchanged(self, members: Message) -> Message:
        if self._last is None:
            return {}
        before, state = self._last
        return {
            member: getattr(state, self._NAMES[member])
            for member, value in members.items()
            if isinstance(value, (dict, list)) and member in self._NAMES and before.get(member) == value
        }


class DroneChange:
    """A drone as it was said last; read into its type when somebody looks at it."""

    __slots__ = ("_members", "_reader", "_state", "id")

    def __init__(self, members: Message, reader: StateReader) -> None:
        self.id: str = members["id"]
        self._members = members
        self._reader = reader
        self._state: DroneView | None = None

    @property
    def name(self) -> str:
        return str(self._members.get("name", self.id))

    @property
    def state(self) -> DroneView:
        if self._state is None:
            self._state = self._reader.read(self._members)
        return self._state


class Stream:
    """One connection to the stream for all readers of a client.

    Drones that are out of sight are missing in `drones`. Whoever waits for a change of a command has to look for
    himself after `interruptions` has grown: what was said meanwhile is not said again.
    """

    def __init__(self, transport: Transport, port: Callable[[], Awaitable[int]], rate: float | None = None) -> None:
        self._transport = transport
        self._port = port
        self._rate = rate
        self.drones: dict[str, DroneChange] = {}
        self._readers: dict[str, StateReader] = {}
        self.interruptions = 0
        self._up = asyncio.Event()
        self._task: asyncio.Task[None] | None = None
        self._socket: StreamSocket | None = None
        self._changes: list[Reader[DroneChange]] = []
        self._messages: list[tuple[frozenset[str], Reader[Message]]] = []
        self._failure: DronemapError | None = None

    def start(self) -> None:
        if self._task is None:
            self._task = asyncio.get_running_loop().create_task(self._run())

    @property
    def connected(self) -> bool:
        return self._up.is_set()

    async def ready(self) -> None:
        """Returns when the list of all drones has come; raises why that is refused."""
        self.start()
        waiting = asyncio.ensure_future(self._up.wait())
        assert self._task is not None
        await asyncio.wait({waiting, self._task}, return_when=asyncio.FIRST_COMPLETED)
        waiting.cancel()
        if self._failure is not None:
            raise self._failure

    def changes(self) -> Reader[DroneChange]:
        """Changed drones, the newest state of each; first all that are known."""
        reader: Reader[DroneChange] = Reader(lambda change: change.id, self._forget_changes)
        self._changes.append(reader)
        for change in self.drones.values():
            reader.put(change)
        self._admit(reader)
        return reader

    def messages(self, types: frozenset[str], key: Callable[[Message], Hashable] | None) -> Reader[Message]:
        """Messages of these types as they came."""
        reader: Reader[Message] = Reader(key, self._forget_messages)
        self._messages.append((types, reader))
        self._admit(reader)
        return reader

    def _admit(self, reader: Reader[Any]) -> None:
        self.start()
        if self._failure is not None:
            reader.end(self._failure)

    async def send(self, message: Message) -> None:
        """Raises `StreamClosed` while there is no connection: what is sent many times a second is not kept."""
        if self._socket is None or not self._up.is_set():
            raise StreamClosed("There is no connection to the stream at the moment.")
        await self._socket.send(json.dumps(message))

    async def close(self) -> None:
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)
        self._end_all(None)

    def _forget_changes(self, reader: Reader[DroneChange]) -> None:
        self._changes = [other for other in self._changes if other is not reader]

    def _forget_messages(self, reader: Reader[Message]) -> None:
        self._messages = [(types, other) for types, other in self._messages if other is not reader]

    def _end_all(self, error: Exception | None) -> None:
        for changes in self._changes:
            changes.end(error)
        for _, messages in self._messages:
            messages.end(error)

    async def _run(self) -> None:
        pause = _FIRST_PAUSE
        while True:
            try:
                port = await self._port()
                async with self._transport.stream(port) as self._socket:
                    await self._listen(self._socket)
            except (StreamClosed, TimeoutError):
                pass
            except (Problem, ServerLacks) as e:
                # A key that is not good stays so.
                self._failure = e
                self._end_all(e)
                return
            except DronemapError:
                pass
            finally:
                self._socket = None
                if self._up.is_set():
                    self.interruptions += 1
                    pause = _FIRST_PAUSE
                self._up.clear()
            await asyncio.sleep(pause * random.uniform(0.7, 1.3))
            pause = min(_LONGEST_PAUSE, 2 * pause)

    async def _listen(self, socket: StreamSocket) -> None:
        loop = asyncio.get_running_loop()
        if self._rate is not None:
            await socket.send(json.dumps({"type": "subscribe", "drones": None, "rate": self._rate}))
        async with asyncio.timeout(_SILENT_SECONDS) as limit:
            while True:
                message = from_json(await socket.receive())
                kind = message.get("type")
                if kind == "drone":
                    self._changed(message["drone"])
                    continue
                limit.reschedule(loop.time() + _SILENT_SECONDS)
                if kind == "drones":
                    self._listed(message["drones"])
                elif kind == "droneRemoved":
                    self.drones.pop(message["id"], None)
                    self._readers.pop(message["id"], None)
                for types, reader in self._messages:
                    if kind in types:
                        reader.put(message)

    def _listed(self, drones: list[Message]) -> None:
        self._readers = {drone["id"]: self._readers.get(drone["id"]) or StateReader() for drone in drones}
        self.drones = {drone["id"]: DroneChange(drone, self._readers[drone["id"]]) for drone in drones}
        for change in self.drones.values():
            for reader in self._changes:
                reader.put(change)
        self._up.set()

    def _changed(self, drone: Message) -> None:
        reader = self._readers.setdefault(drone["id"], StateReader())
        change = DroneChange(drone, reader)
        self.drones[change.id] = change
        for waiting in self._changes:
            waiting.put(change)
