"""A mission, step by step."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal

from dronemap.contract.models import (
    LandItem,
    LookAheadItem,
    LookAtItem,
    MissionItemRequest,
    ReturnToLaunchItem,
    SetServoItem,
    TakeOffItem,
    TakePhotoItem,
    WaitItem,
    WaypointItem,
)

Reference = Literal["home", "amsl"]


@dataclass
class Mission:
    """The steps that a vehicle flies, in order. Each method adds one and returns the mission.

    Heights are metres above home, or with `reference="amsl"` above mean sea level.
    """

    items: list[MissionItemRequest] = field(default_factory=list)

    def take_off(self, altitude: float) -> "Mission":
        return self._add(TakeOffItem(altitude=altitude))

    def waypoint(
        self,
        latitude: float,
        longitude: float,
        altitude: float,
        *,
        hold_seconds: float | None = None,
        reference: Reference = "home",
    ) -> "Mission":
        return self._add(
            WaypointItem(
                latitude=latitude,
                longitude=longitude,
                altitude=altitude,
                altitude_reference=reference,
                hold_seconds=hold_seconds,
            )
        )

    def wait(self, seconds: float) -> "Mission":
        return self._add(WaitItem(hold_seconds=seconds))

    def take_photo(self) -> "Mission":
        return self._add(TakePhotoItem())

    def look_at(self, latitude: float, longitude: float, altitude: float) -> "Mission":
        return self._add(LookAtItem(latitude=latitude, longitude=longitude, altitude=altitude))

    def look_ahead(self) -> "Mission":
        return self._add(LookAheadItem())

    def set_servo(self, output: int, pulse: int) -> "Mission":
        return self._add(SetServoItem(output=output, pulse=pulse))

    def return_home(self) -> "Mission":
        return self._add(ReturnToLaunchItem())

    def land(self) -> "Mission":
        return self._add(LandItem())

    def _add(self, item: MissionItemRequest) -> "Mission":
        self.items.append(item)
        return self

    def __len__(self) -> int:
        return len(self.items)

    def __iter__(self) -> Iterator[MissionItemRequest]:
        return iter(self.items)
