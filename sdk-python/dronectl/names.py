"""The names of drones, for the shell that completes them."""

import asyncio
import re

from dronectl.settings import Settings
from dronemap import DronemapError
from dronemap.contract.models import DroneView

#: Longer than that nobody waits for a completion.
_SECONDS = 1.5
#: Shells take these as one word without quotes.
_WORD = re.compile(r"[\w.+@-]+")


def drone_names(settings: Settings) -> list[tuple[str, str]]:
    """What to write for each drone, and what to say about it; empty when the server does not answer at once."""
    try:
        drones = asyncio.run(_listed(settings))
    except (DronemapError, TimeoutError, OSError):
        # A completion has nowhere to report to; the command itself will say what is wrong.
        return []
    return [
        (drone.name, drone.mode or "") if _WORD.fullmatch(drone.name) else (drone.id, drone.name)
        for drone in sorted(drones, key=lambda drone: drone.name)
    ]


async def _listed(settings: Settings) -> list[DroneView]:
    async with asyncio.timeout(_SECONDS), settings.connect(patience=0) as server:
        return (await server.rest.list_drones()).drones
