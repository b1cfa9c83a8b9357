"""Interfaces of robots to the bridge, for either version of ROS; metres, radians, seconds."""

from dataclasses import dataclass, field
from typing import List, Optional, Protocol


@dataclass(frozen=True)
class Pose:
    """In the frame of its map where it knows how it stands there, else in that of its odometry.

    ``height`` is above where it started, and None on wheels.
    """

    x: float
    y: float
    yaw: float
    forward: float = 0.0
    left: float = 0.0
    turn: float = 0.0
    up: float = 0.0
    height: Optional[float] = None


@dataclass(frozen=True)
class Scan:
    first_angle: float
    step: float
    least: float
    most: float
    ranges: List[float] = field(default_factory=list)


@dataclass(frozen=True)
class Map:
    """Rows from the bottom up, as ROS keeps them: -1 unknown, 0 free to 100 occupied."""

    columns: int
    rows: int
    resolution: float
    left: float
    bottom: float
    cells: List[int] = field(default_factory=list)


@dataclass(frozen=True)
class Speeds:
    forward: float = 0.0
    left: float = 0.0
    up: float = 0.0
    turn: float = 0.0


@dataclass(frozen=True)
class Battery:
    """Per cent, volts and amperes; None where it does not know."""

    per_cent: Optional[float] = None
    volts: Optional[float] = None
    amperes: Optional[float] = None


@dataclass(frozen=True)
class Flight:
    """State of a flight controller: its state as MAVLink numbers it, its mode as ArduCopter does."""

    state: int
    armed: bool
    mode: int


@dataclass(frozen=True)
class Satellites:
    """Degrees, and metres above the sea; ``fix`` -1 none, 3 in three dimensions, 4 with corrections."""

    fix: int
    latitude: Optional[float] = None
    longitude: Optional[float] = None
    altitude: Optional[float] = None
    visible: Optional[int] = None


class Robot(Protocol):
    """A robot with the newest of its data; None where there is none yet."""

    def pose(self) -> Optional[Pose]: ...

    def scan(self) -> Optional[Scan]: ...

    def image(self) -> Optional[bytes]:
        """A JPEG or PNG."""

    def map(self) -> Optional[Map]: ...

    def battery(self) -> Optional[Battery]: ...

    def drive(self, speeds: Speeds) -> None: ...

    def go_to(self, x: float, y: float) -> None:
        """In the frame of its map."""

    def cancel(self) -> None:
        """Gives up where it is going to."""


class Flyer(Robot, Protocol):
    """A drone; orders are carried out some time later, or not at all, and nothing here waits for it."""

    def flight(self) -> Optional[Flight]: ...

    def satellites(self) -> Optional[Satellites]: ...

    def arm(self, wanted: bool) -> None: ...

    def set_mode(self, number: int) -> None:
        """Sets a mode by ArduCopter's number."""

    def take_off(self, height: float) -> None: ...

    def land(self) -> None: ...
