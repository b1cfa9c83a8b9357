"""The bridge of a drone behind mavros, without I/O."""

from typing import Any, Callable, ClassVar, Dict, List, Optional, Tuple

from .bridge import GO_TO, SATELLITES, STATUS, Bridge, Identity, Message, OutgoingMessage, known, number
from .robot import Flyer

TAKE_OFF, LAND, ARM, DISARM, SET_MODE = 102, 103, 104, 105, 106


class FlyingBridge(Bridge):
    """A drone obeys speeds, and arms, takes off, lands and changes its mode; it goes to no place of a map."""

    NEEDED: ClassVar[Dict[int, Tuple[str, ...]]] = {
        **Bridge.NEEDED,
        TAKE_OFF: ("altitude",),
        SET_MODE: ("flightMode",),
    }

    def __init__(self, identity: Identity, flyer: Flyer) -> None:
        self._flyer = flyer
        super().__init__(identity, flyer)

    def _kinds(self) -> Dict[int, Callable[[], Optional[Message]]]:
        return {**super()._kinds(), STATUS: self._flight, SATELLITES: self._satellites}

    def _execute(self, kind: int, order: Message, now: float) -> List[OutgoingMessage]:
        if kind == TAKE_OFF and 0 < number(order, "altitude") <= self._identity.max_height:
            self._flyer.take_off(number(order, "altitude"))
        elif kind == SET_MODE:
            self._flyer.set_mode(int(number(order, "flightMode")))
        elif kind == LAND:
            self._flyer.land()
        elif kind in (ARM, DISARM):
            self._flyer.arm(kind == ARM)
        elif kind in (TAKE_OFF, GO_TO):
            self.refused += 1
        else:
            return super()._execute(kind, order, now)
        return []

    def _flight(self) -> Optional[Message]:
        """State of a drone in one number: thousands the system's state, hundreds armed, the rest the mode."""
        battery, flight = self._flyer.battery(), self._flyer.flight()
        status: Dict[str, Any] = {} if battery is None else known(self._charge(battery))
        if flight is not None:
            status["state"] = 1000 * flight.state + 100 * flight.armed + flight.mode
        return status or None

    def _satellites(self) -> Optional[Message]:
        seen = self._flyer.satellites()
        if seen is None:
            return None
        return known(
            {
                "fix_type": seen.fix,
                "lat": seen.latitude,
                "lon": seen.longitude,
                "alt": seen.altitude,
                "satellites_visible": seen.visible,
            }
        )
