"""The vehicles that exchanges are recorded of: how each is started in software-in-the-loop, and its exchanges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pymavlink import mavutil

from exchange import Exchange
from exchanges import EXCHANGES
from firmware_exchanges import FIRMWARE_EXCHANGES
from planes import PLANE_EXCHANGES, QUADPLANE_EXCHANGES
from return_exchanges import COPTER_RETURNS, PLANE_RETURNS, ROVER_RETURNS
from rover_exchanges import ROVER_EXCHANGES


@dataclass(frozen=True)
class Vehicle:
    """One kind: the model of its physics, its file of defaults, the names of its modes, the exchanges with it."""

    model: str
    defaults: str
    mode_names: Mapping[int, str]
    exchanges: tuple[Exchange, ...]


VEHICLES: Mapping[str, Vehicle] = {
    "copter": Vehicle(
        "+", "copter.parm", dict(mavutil.mode_mapping_acm), (*EXCHANGES, *FIRMWARE_EXCHANGES, *COPTER_RETURNS)
    ),
    "plane": Vehicle("plane", "plane.parm", dict(mavutil.mode_mapping_apm), (*PLANE_EXCHANGES, *PLANE_RETURNS)),
    "quadplane": Vehicle("quadplane", "quadplane.parm", dict(mavutil.mode_mapping_apm), QUADPLANE_EXCHANGES),
    "rover": Vehicle("rover", "rover.parm", dict(mavutil.mode_mapping_rover), (*ROVER_EXCHANGES, *ROVER_RETURNS)),
}
ALL_EXCHANGES: tuple[Exchange, ...] = tuple(exchange for vehicle in VEHICLES.values() for exchange in vehicle.exchanges)
