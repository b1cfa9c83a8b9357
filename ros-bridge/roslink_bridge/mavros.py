"""Converts messages of mavros, the same in both versions of ROS."""

import math
from typing import Any, Dict, Optional

from .robot import Flight, Satellites, Speeds

#: ArduCopter's modes by its own numbers; those that the cloud sets, and those that a pilot may choose.
MODES: Dict[int, str] = {
    0: "STABILIZE",
    1: "ACRO",
    2: "ALT_HOLD",
    3: "AUTO",
    4: "GUIDED",
    5: "LOITER",
    6: "RTL",
    7: "CIRCLE",
    9: "LAND",
    11: "DRIFT",
    13: "SPORT",
    16: "POSHOLD",
    17: "BRAKE",
    20: "GUIDED_NOGPS",
    21: "SMART_RTL",
}
NUMBERS = {name: number for number, name in MODES.items()}
OTHER_MODE = 99
#: PositionTarget: speeds along its own axes, and how fast it turns; nothing else counts.
OWN_AXES, SPEEDS_ONLY = 8, 0b0101_1100_0111
NO_FIX, FIX, CORRECTED = -1, 3, 4


def flight_of(state: Any) -> Optional[Flight]:
    """Flight of a mavros_msgs/State; None without a flight controller."""
    if state is None or not state.connected:
        return None
    return Flight(state.system_status, bool(state.armed), NUMBERS.get(state.mode, OTHER_MODE))


def satellites_of(fix: Any, visible: Any, altitude: Any) -> Optional[Satellites]:
    """A NavSatFix counts its altitude from the ellipsoid: above the sea only mavros_msgs/Altitude says it."""
    if fix is None:
        return None
    number = None if visible is None else int(visible.data)
    if fix.status.status < 0:
        return Satellites(NO_FIX, visible=number)
    above = None if altitude is None or not math.isfinite(altitude.amsl) else float(altitude.amsl)
    corrected = CORRECTED if fix.status.status > 0 else FIX
    return Satellites(corrected, fix.latitude, fix.longitude, above, number)


def fill_target(target: Any, speeds: Speeds) -> None:
    """Fills a mavros_msgs/PositionTarget."""
    target.coordinate_frame, target.type_mask = OWN_AXES, SPEEDS_ONLY
    target.velocity.x, target.velocity.y, target.velocity.z = speeds.forward, speeds.left, speeds.up
    target.yaw_rate = speeds.turn
