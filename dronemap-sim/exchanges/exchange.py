"""An exchange: what is done with one freshly started vehicle while everything is recorded."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from vehicle_link import VehicleLink


@dataclass(frozen=True)
class Exchange:
    """A name (also the file's), what it shows, the parameters set before it, and what is done.

    `boot_parameters` are there from power-up on.
    """

    name: str
    shows: str
    run: Callable[[VehicleLink], None]
    parameters: Mapping[str, float] = field(default_factory=dict)
    boot_parameters: Mapping[str, float] = field(default_factory=dict)
    from_power_up: bool = False
    log_heartbeats: bool = False
