"""A drone that follows a phone, or whatever knows where it is, for programs that await."""

import asyncio
import time
from collections.abc import AsyncIterator
from datetime import UTC, datetime

from dronemap.contract.models import (
    FollowPositionRequest,
    FollowPositionsRequest,
    FollowReceipt,
    FollowView,
)
from dronemap.contract.operations import Operations
from dronemap.stream import Stream
from dronemap.tracked import Tracked


def _is_over(follow: FollowView) -> bool:
    return follow.state == "over"


class AsyncFollow:
    """A follow: the drone keeps its place beside the positions that are reported.

    Positions are reported once a second; the drone holds when none come, and flies home when that lasts.
    """

    def __init__(self, view: FollowView, rest: Operations, stream: Stream) -> None:
        self.id = view.id
        self._rest = rest
        self._tracked = Tracked(view, stream, "follow", lambda: rest.get_follow(view.id))
        self._number = int(time.time() * 1000)
        self._round_trip: float | None = None

    @property
    def view(self) -> FollowView:
        return self._tracked.view

    def progress(self) -> AsyncIterator[FollowView]:
        return self._tracked.progress(_is_over)

    async def wait(self, timeout: float | None = None) -> FollowView:
        """Returns when it is over; `view.end` says how."""
        return await self._tracked.until(_is_over, timeout)

    async def start(self) -> FollowView:
        """The drone takes off and comes."""
        return await self._rest.start_follow(self.id)

    async def report(
        self,
        latitude: float,
        longitude: float,
        *,
        accuracy: float | None = None,
        speed: float | None = None,
        course: float | None = None,
        at: datetime | None = None,
    ) -> FollowReceipt:
        """Tells where the phone is: degrees, metres, m/s, degrees from true north."""
        now = datetime.now(UTC)
        self._number += 1
        position = FollowPositionRequest(
            latitude=latitude,
            longitude=longitude,
            accuracy=accuracy,
            speed=speed,
            course=course,
            at=at or now,
            id=self._number,
        )
        loop = asyncio.get_running_loop()
        begun = loop.time()
        asked = FollowPositionsRequest(positions=[position], sent=now, round_trip=self._round_trip)
        receipt = await self._rest.report_follow_positions(self.id, asked)
        self._round_trip = (loop.time() - begun) * 1000
        return receipt

    async def pause(self) -> FollowView:
        """The drone holds."""
        return await self._rest.pause_follow(self.id)

    async def resume(self) -> FollowView:
        return await self._rest.continue_follow(self.id)

    async def stop(self) -> FollowView:
        """The drone returns home."""
        return await self._rest.stop_follow(self.id)

    async def cancel(self) -> FollowView:
        """Gives the drone back before it has taken off."""
        return await self._rest.cancel_follow(self.id)
