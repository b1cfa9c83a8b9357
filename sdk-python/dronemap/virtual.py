"""Virtual drones, for programs that await."""

from collections.abc import AsyncIterator
from typing import Literal

from dronemap.contract.models import VirtualDroneStartRequest, VirtualDroneView
from dronemap.contract.operations import Operations
from dronemap.errors import DronemapError
from dronemap.stream import Stream
from dronemap.tracked import Tracked

_ENDED = ("done", "failed", "stopped")


def _is_over(drone: VirtualDroneView) -> bool:
    return drone.run is None or drone.run.state in _ENDED


class MissionFailed(DronemapError):
    """A virtual drone's mission did not come to its end; the text says why."""


class AsyncVirtualDrone:
    """A virtual drone: it is bound to a drone of the warehouse when its mission is started."""

    def __init__(self, view: VirtualDroneView, rest: Operations, stream: Stream) -> None:
        self.id = view.id
        self._rest = rest
        self._tracked = Tracked(view, stream, "virtualDrone", lambda: rest.get_virtual_drone(view.id))

    @property
    def view(self) -> VirtualDroneView:
        return self._tracked.view

    def progress(self) -> AsyncIterator[VirtualDroneView]:
        """Its mission as it goes on, up to its end."""
        return self._tracked.progress(_is_over)

    async def start(self, on_cloud_loss: Literal["continue", "rtl"] | None = None) -> VirtualDroneView:
        self._tracked.view = await self._rest.start_virtual_drone(
            self.id, VirtualDroneStartRequest(on_cloud_loss=on_cloud_loss)
        )
        return self.view

    async def wait(self, timeout: float | None = None) -> VirtualDroneView:
        """Returns when its mission has come to its end; raises `MissionFailed` when it has not."""
        view = await self._tracked.until(_is_over, timeout)
        if view.run is not None and view.run.state != "done":
            raise MissionFailed(view.run.sentence)
        return view

    async def stop(self) -> VirtualDroneView:
        return await self._rest.stop_virtual_drone(self.id)

    async def resume(self) -> VirtualDroneView:
        return await self._rest.resume_virtual_drone(self.id)

    async def remove(self) -> None:
        await self._rest.remove_virtual_drone(self.id)
