"""A server, for programs that do not await."""

from collections.abc import Iterable, Iterator
from typing import Literal

from dronemap.client import PATIENCE_SECONDS, AsyncDronemap
from dronemap.contract.models import FollowPlaceRequest, PlanRequest
from dronemap.mission import Mission
from dronemap.reader import Reader
from dronemap.stream import DroneChange
from dronemap.sync.drone import Drone
from dronemap.sync.events import Events
from dronemap.sync.loop import LoopThread
from dronemap.sync.operations import SyncOperations
from dronemap.sync.tracked import Dispatch, Follow, Plan, Recovery, Run, VirtualDrone
from dronemap.transport import Transport


class Dronemap:
    """A Dronemap server. `with Dronemap.connect() as server:` closes its connections at the end."""

    def __init__(self, awaited: AsyncDronemap) -> None:
        self._loop = LoopThread()
        self._awaited = awaited
        self.rest = SyncOperations(self._loop, awaited.rest)

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
    ) -> "Dronemap":
        """A server by its address and an access key, or by the environment or a file (`find_server`).

        `certificate` is the file of an authority to trust in addition; `patience` seconds are tried again for what
        fails and cannot act twice; `rate` is how often a second each drone is told of at most, 1 to 50.
        """
        return cls(
            AsyncDronemap.connect(
                url,
                key,
                certificate=certificate,
                profile=profile,
                transport=transport,
                patience=patience,
                rate=rate,
            )
        )

    @property
    def server_version(self) -> str | None:
        """As the server said with its last answer; None before the first."""
        return self._awaited.server_version

    def drones(self) -> list[Drone]:
        """All drones that this user sees, in the order of their names."""
        return [Drone(self._loop, drone) for drone in self._loop.run(self._awaited.drones())]

    def drone(self, name: str | None = None) -> Drone:
        """The drone of that name or id; without one, the only drone."""
        return Drone(self._loop, self._loop.run(self._awaited.drone(name)))

    def changes(self) -> Iterator[DroneChange]:
        """All drones, and each again when it changes; the newest state wins."""

        async def begun() -> Reader[DroneChange]:
            return self._awaited.changes()

        return self._loop.read(self._loop.run(begun()))

    def events(self, after: str | None = None, drones: Iterable[str] = ()) -> Events:
        """What happens to drones from now on, or after a cursor; `drones` are ids, all unless said otherwise."""
        return Events(self._loop, self._loop.run(self._awaited.events(after, drones)))

    def plan(self, request: PlanRequest) -> Plan:
        """Shares waypoints out among drones; the search goes on at the server."""
        return Plan(self._loop, self._loop.run(self._awaited.plan(request)))

    def runs(self) -> list[Run]:
        return [Run(self._loop, run) for run in self._loop.run(self._awaited.runs())]

    def run(self, id: str) -> Run:
        return Run(self._loop, self._loop.run(self._awaited.run(id)))

    def follow(
        self,
        latitude: float,
        longitude: float,
        *,
        drone: str | None = None,
        minutes: float | None = None,
        place: FollowPlaceRequest | None = None,
        name: str | None = None,
    ) -> Follow:
        """Asks for a drone that follows; without `drone` the server chooses one of the warehouse."""
        asked = self._awaited.follow(latitude, longitude, drone=drone, minutes=minutes, place=place, name=name)
        return Follow(self._loop, self._loop.run(asked))

    def send(
        self, latitude: float, longitude: float, *, height: float | None = None, minutes: float | None = None
    ) -> Dispatch:
        """Sends the best free drone of the pool there, `height` metres above its home; who asks gets its control."""
        asked = self._awaited.send(latitude, longitude, height=height, minutes=minutes)
        return Dispatch(self._loop, self._loop.run(asked))

    def recover(
        self, manner: Literal["return", "land"], drones: list[str] | None = None, *, take_over: bool = False
    ) -> Recovery:
        """Brings drones home, or has them land, each in its turn; without `drones` all that you may command."""
        return Recovery(self._loop, self._loop.run(self._awaited.recover(manner, drones, take_over=take_over)))

    def virtual_drones(self) -> list[VirtualDrone]:
        return [VirtualDrone(self._loop, drone) for drone in self._loop.run(self._awaited.virtual_drones())]

    def add_virtual_drone(self, name: str, mission: Mission | None = None, up_to: int | None = None) -> VirtualDrone:
        """`up_to`: so many drones may share its mission; one, where it is left out."""
        return VirtualDrone(self._loop, self._loop.run(self._awaited.add_virtual_drone(name, mission, up_to)))

    def close(self) -> None:
        self._loop.run(self._awaited.close())
        self._loop.close()

    def __enter__(self) -> "Dronemap":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
