"""Programs for a Dronemap server: list, watch and command drones.

    from dronemap import Dronemap

    with Dronemap.connect() as server, server.drones()[0].control() as drone:
        drone.arm()
        drone.take_off(10)

`Dronemap` is for programs that do not await, `AsyncDronemap` the same for those that do; `rest` of either has a
typed call for each operation of the server, `dronemap.contract.models` the types.
"""

from dronemap.arrival import Interrupted
from dronemap.client import AsyncDronemap, NoSuchDrone
from dronemap.connection import Server, find_server
from dronemap.contract import models
from dronemap.contract.models import EventGap, NumberedEvent
from dronemap.dispatch import NotHere
from dronemap.errors import (
    AnswerLost,
    ControlLost,
    DronemapError,
    NotConfigured,
    Problem,
    ServerLacks,
    Unreachable,
    WaitedTooLong,
)
from dronemap.events import FIRST
from dronemap.geo import meters_between, offset
from dronemap.mission import Mission
from dronemap.outcome import (
    CommandError,
    Failed,
    Outcome,
    OutcomeUnknown,
    Refused,
    Succeeded,
    Superseded,
    TimedOut,
)
from dronemap.plan import PlanFailed
from dronemap.sync.client import Dronemap
from dronemap.sync.drone import Control, Drone, GivenCommand
from dronemap.version import VERSION as __version__
from dronemap.virtual import MissionFailed

__all__ = [
    "AnswerLost",
    "AsyncDronemap",
    "CommandError",
    "Control",
    "ControlLost",
    "Drone",
    "Dronemap",
    "DronemapError",
    "EventGap",
    "FIRST",
    "Failed",
    "GivenCommand",
    "Interrupted",
    "Mission",
    "MissionFailed",
    "NoSuchDrone",
    "NotHere",
    "NotConfigured",
    "NumberedEvent",
    "Outcome",
    "OutcomeUnknown",
    "PlanFailed",
    "Problem",
    "Refused",
    "Server",
    "ServerLacks",
    "Succeeded",
    "Superseded",
    "TimedOut",
    "Unreachable",
    "WaitedTooLong",
    "__version__",
    "find_server",
    "meters_between",
    "models",
    "offset",
]
