"""Four drones take off together, fly a square side by side, and return. Writes swarm.geojson: their tracks.

Each drone has a task of its own that awaits; that is all it takes to fly several at once. Each square begins at the
drone's own home and has a height of its own, so that their ways home do not meet.
"""

import asyncio
import json
from pathlib import Path

from dronemap import AsyncDronemap, offset
from dronemap.drone import AsyncDrone

SIDE = 30.0
CORNERS = [(SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE), (0.0, 0.0)]


async def fly_square(drone: AsyncDrone, height: float) -> dict[str, object]:
    state = await drone.wait_for(lambda state: state.ready_to_arm is True and state.position is not None, 60)
    assert state.position is not None
    latitude, longitude = state.position.latitude, state.position.longitude
    assert latitude is not None and longitude is not None
    async with drone.control() as pilot:
        await pilot.arm()
        await pilot.take_off(height)
        for north, east in CORNERS:
            await pilot.go_to(*offset(latitude, longitude, north, east), height)
        await pilot.return_home()
    table = await drone.telemetry(since=state.last_update)
    track = [[point.longitude, point.latitude, point.altitude_amsl] for point in table.points]
    print(f"{drone.name} is back.")
    return {
        "type": "Feature",
        "properties": {"name": drone.name, "height": height},
        "geometry": {"type": "LineString", "coordinates": track},
    }


async def main() -> None:
    async with AsyncDronemap.connect() as server:
        four = (await server.drones())[:4]
        flown = await asyncio.gather(*(fly_square(drone, 10 + 5 * i) for i, drone in enumerate(four)))
    collection = {"type": "FeatureCollection", "features": flown}
    Path("swarm.geojson").write_text(json.dumps(collection))


asyncio.run(main())
