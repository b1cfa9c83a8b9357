"""A server, for programs that await."""

from collections.abc import Iterable
from typing import Literal

from dronemap.connection import find_server
from dronemap.contract.models import (
    DispatchRequest,
    FollowOpenRequest,
    FollowPlaceRequest,
    PlanRequest,
    RecoveryRequest,
    VirtualDroneRequest,
)
from dronemap.contract.operations import Operations
from dronemap.dispatch import AsyncDispatch
from dronemap.drone import AsyncDrone
from dronemap.errors import DronemapError
from dronemap.events import AsyncEvents
from dronemap.follow import AsyncFollow
from dronemap.mission import Mission
from dronemap.plan import AsyncPlan, AsyncRun
from dronemap.reader import Reader
from dronemap.recovery import AsyncRecovery
from dronemap.sender import Sender
from dronemap.stream import DroneChange, Stream
from dronemap.transport import HttpTransport, Transport
from dronemap.virtual import AsyncVirtualDrone

#: Seconds for which what cannot act twice is tried again.
PATIENCE_SECONDS = 15.0


class NoSuchDrone(DronemapError):
    """The server shows no drone of that name or id, or it is not clear which is meant."""


class AsyncDronemap:
    """A Dronemap server. `async with AsyncDronemap.connect() as server:` closes its connections at the end."""

    def __init__(self, transport: Transport, *, patience: float = PATIENCE_SECONDS, rate: float | None = None) -> None:
        self._transport = transport
        self._sender = Sender(transport, patience)
        self.rest = Operations(self._sender)
        self.stream = Stream(transport, self._stream_port, rate)

    @classmethod
    def connect(
        cls,
        url: str | None = None,
        key: str | None = None,
        *,
        certificate: str | None = None,
        profile: str | None = None,
        transport: Transport | None = None,
        patience: float = PATIENCE_SECONDS,
        rate: float | None = None,
    ) -> "AsyncDronemap":
        """A server by its address and an access key, or by the environment or a file (`find_server`).

        `certificate` is the file of an authority to trust in addition; `patience` seconds are tried again for what
        fails and cannot act twice; `rate` is how often a second each drone is told of at most, 1 to 50.
        """
        if transport is None:
            transport = HttpTransport(find_server(url, key, certificate=certificate, profile=profile))
        return cls(transport, patience=patience, rate=rate)

    @property
    def server_version(self) -> str | None:
        """As the server said with its last answer; None before the first."""
        return self._sender.server_version

    async def drones(self) -> list[AsyncDrone]:
        """All drones that this user sees, in the order of their names."""
        self.stream.start()
        known = (await self.rest.list_drones()).drones
        return [AsyncDrone(view, self.rest, self.stream) for view in sorted(known, key=lambda view: view.name)]

    async def drone(self, name: str | None = None) -> AsyncDrone:
        """The drone of that name or id; without one, the only drone."""
        found = await self.drones()
        fitting = [drone for drone in found if name is None or name in (drone.id, drone.name)]
        names = ", ".join(drone.name for drone in found) or "none"
        if not fitting:
            raise NoSuchDrone(f"There is no drone '{name}'; there are: {names}." if name else "There is no drone.")
        if len(fitting) > 1:
            raise NoSuchDrone(f"Several drones fit ({names}): say which, by its name or id.")
        return fitting[0]

    def changes(self) -> Reader[DroneChange]:
        """All drones, and each again when it changes; the newest state wins."""
        return self.stream.changes()

    async def events(self, after: str | None = None, drones: Iterable[str] = ()) -> AsyncEvents:
        """What happens to drones from now on, or after a cursor; `drones` are ids, all unless said otherwise."""
        return await AsyncEvents.begin(self.rest, after, drones)

    async def plan(self, request: PlanRequest) -> AsyncPlan:
        """Shares waypoints out among drones; the search goes on at the server."""
        return AsyncPlan(await self.rest.make_plan(request), self.rest, self.stream)

    async def runs(self) -> list[AsyncRun]:
        return [AsyncRun(view, self.rest, self.stream) for view in (await self.rest.list_runs()).runs]

    async def run(self, id: str) -> AsyncRun:
        return AsyncRun(await self.rest.get_run(id), self.rest, self.stream)

    async def follow(
        self,
        latitude: float,
        longitude: float,
        *,
        drone: str | None = None,
        minutes: float | None = None,
        place: FollowPlaceRequest | None = None,
        name: str | None = None,
    ) -> AsyncFollow:
        """Asks for a drone that follows; without `drone` the server chooses one of the warehouse."""
        asked = FollowOpenRequest(
            latitude=latitude, longitude=longitude, drone=drone, minutes=minutes, place=place, name=name
        )
        return AsyncFollow(await self.rest.open_follow(asked), self.rest, self.stream)

    async def send(
        self, latitude: float, longitude: float, *, height: float | None = None, minutes: float | None = None
    ) -> AsyncDispatch:
        """Sends the best free drone of the pool there, `height` metres above its home; who asks gets its control."""
        asked = DispatchRequest(latitude=latitude, longitude=longitude, height=height, minutes=minutes)
        return AsyncDispatch(await self.rest.send_drone(asked), self.rest, self.stream)

    async def recover(
        self, manner: Literal["return", "land"], drones: list[str] | None = None, *, take_over: bool = False
    ) -> AsyncRecovery:
        """Brings drones home, or has them land, each in its turn; without `drones` all that you may command."""
        asked = RecoveryRequest(manner=manner, drones=drones, take_over=take_over or None)
        return AsyncRecovery(await self.rest.begin_recovery(asked), self.rest, self.stream)

    async def virtual_drones(self) -> list[AsyncVirtualDrone]:
        listed = await self.rest.list_virtual_drones()
        return [AsyncVirtualDrone(view, self.rest, self.stream) for view in listed.virtual_drones]

    async def add_virtual_drone(
        self, name: str, mission: Mission | None = None, up_to: int | None = None
    ) -> AsyncVirtualDrone:
        """`up_to`: so many drones may share its mission; one, where it is left out."""
        asked = VirtualDroneRequest(name=name, items=None if mission is None else mission.items, up_to=up_to)
        return AsyncVirtualDrone(await self.rest.add_virtual_drone(asked), self.rest, self.stream)

    async def close(self) -> None:
        await self.stream.close()
        await self._transport.close()

    async def __aenter__(self) -> "AsyncDronemap":
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def _stream_port(self) -> int:
        return (await self.rest.get_settings()).stream_port
