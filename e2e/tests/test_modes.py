"""Every mode that pymavlink knows of an autopilot has the same name here and can be set by it."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

import pytest
from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api
from dronemap_e2e.peer import OBEDIENT, Kind, Peer
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for


@dataclass(frozen=True)
class Autopilot:
    name: str
    kind: Kind
    modes: dict[int, str]


def px4_custom_modes() -> dict[int, str]:
    """px4_map holds (base mode, main mode, sub mode) by name."""
    return {(main << 16) | (sub << 24): name for name, (_, main, sub) in mavutil.px4_map.items()}


AUTOPILOTS = [
    Autopilot("ArduCopter", Kind(mavlink.MAV_TYPE_QUADROTOR), mavutil.mode_mapping_acm),
    Autopilot("ArduPlane", Kind(mavlink.MAV_TYPE_FIXED_WING), mavutil.mode_mapping_apm),
    Autopilot("ArduRover", Kind(mavlink.MAV_TYPE_GROUND_ROVER), mavutil.mode_mapping_rover),
    Autopilot("ArduSub", Kind(mavlink.MAV_TYPE_SUBMARINE), mavutil.mode_mapping_sub),
    Autopilot("PX4", Kind(mavlink.MAV_TYPE_QUADROTOR, mavlink.MAV_AUTOPILOT_PX4), px4_custom_modes()),
]


@pytest.fixture(params=AUTOPILOTS, ids=lambda a: a.name)
def autopilot(request: pytest.FixtureRequest) -> Autopilot:
    chosen: Autopilot = request.param
    return chosen


@pytest.fixture
def peer(server: Server, autopilot: Autopilot) -> Iterator[Peer]:
    opened = Peer(server.udp_port, kind=autopilot.kind, handlers=OBEDIENT)
    yield opened
    opened.close()


def test_every_mode_has_pymavlinks_name_and_is_set_by_it(api: Api, peer: Peer, autopilot: Autopilot) -> None:
    # Another vehicle may have been there before from the same port: it is that one until this one is heard.
    drone = wait_for(
        f"the peer is listed as {autopilot.name}",
        lambda: next((d for d in api.drones() if is_there(d, peer, autopilot)), None),
    )

    for number, name in autopilot.modes.items():
        peer.state.custom_mode = number
        peer.beat()
        wait_for(f"{number} is shown as {name}", partial(shows, api, drone["id"], name), 3)
    for number, name in reversed(autopilot.modes.items()):
        api.do(drone["id"], type="setMode", mode=name)
        assert peer.state.custom_mode == number, name


def is_there(drone: dict[str, Any], peer: Peer, autopilot: Autopilot) -> bool:
    return bool(drone["link"]["port"] == peer.port and drone["vehicle"].startswith(autopilot.name))


def shows(api: Api, drone: str, mode: str) -> bool:
    return bool(api.drone(drone)["mode"] == mode)
