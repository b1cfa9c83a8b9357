"""Records what real clients say to a server, in files: python -m dronemap_e2e.wire FOLDER

What the server answers is in the files too, and is what the test that replays them approves
(docs/how-to-add/wire.md). Needs curl, php with its soap extension, and chromium."""

import sys
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

from . import wire_curl, wire_files
from .api import Api
from .runs import known
from .server import Server
from .simulator import QUICK_FLIGHT, Simulator
from .station import launch
from .waiting import wait_for
from .wire_clients import NEAR, Curl, called, php, zeep_client
from .wire_page import use_page
from .wire_relay import Relay


def _by_curl(relay: Relay, curl: Curl) -> tuple[str, str]:
    first, second = wire_curl.look(curl)
    wire_curl.people(curl, first)
    wire_curl.sign_in(curl, relay)
    wire_curl.keys(curl, first)
    wire_curl.command(curl, first)
    wire_curl.control(curl, relay, first)
    wire_curl.missions(curl)
    wire_curl.zones(curl, first)
    wire_curl.virtual_drones(curl)
    wire_curl.plans_and_runs(curl, second)
    wire_curl.follows(curl, relay, first)
    wire_curl.history(curl, first)
    return first, second


def _by_zeep(relay: Relay, key: str, folder: Path, drone: str) -> None:
    service = zeep_client(relay, key, "1.1", "MAVLinkControllerService", folder)
    called(service, "getDronesList")
    called(service, "getDrone", drone)
    called(service, "getDrone", wire_curl.NOBODY)
    called(service, "setMode", drone, "NOSUCHMODE")
    called(service, "setHome", drone, 47.3977, 8.5456, 488.0)
    called(service, "takePicture", drone)
    called(service, "setRelay", drone, 4, "toggle")
    called(service, "setRelay", drone, 400, "toggle")
    called(service, "getParameters", drone, "NOSUCH")
    called(service, "uploadMission", drone, [NEAR, NEAR | {"holdSeconds": 2}])
    called(service, "takeControl", drone)
    called(service, "giveControlBack", drone)
    plan = called(service, "planMission", [drone], [NEAR], None, None, 0.1)
    if plan is not None:
        called(service, "cancelPlan", plan.planId)
    called(service, "createVirtualDrone", "An errand", None, None, [], [NEAR])
    called(service, "getFlightsList", wire_curl.NOBODY, None, None, None)
    called(zeep_client(relay, None, "1.1", "MAVLinkControllerService", folder), "getDronesList")
    follower = zeep_client(relay, key, "1.1", "FollowerService", folder)
    follow = called(follower, "followRequest", drone, 47.398, 8.5456, None, 5, "Ann")
    if follow is not None:
        called(follower, "getFollow", follow.followId)
        called(follower, "cancelFollowRequest", follow.followId)
    newer = zeep_client(relay, key, "1.2", "MAVLinkControllerService", folder)
    called(newer, "getDronesList")
    called(newer, "getDrone", drone)
    called(newer, "arm", wire_curl.NOBODY)


def record(folder: Path) -> int:
    """How many exchanges there are now."""
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        server = Server(work / "data")
        server.start()
        address = f"udp://127.0.0.1:{server.udp_port}"
        simulator = Simulator(work / "sim.log", address, "--count", "2", *QUICK_FLIGHT)
        relay = Relay(server.http_port)
        try:
            key, password = server.local_key(), server.first_password()
            api = Api(server.address, key)
            wait_for("all is known", lambda: all(known(api, number) for number in (1, 2)), 150)
            curl = Curl(relay, key)
            first, second = _by_curl(relay, curl)
            _by_zeep(relay, key, work, first)
            php(relay, key, "1.1", first)
            php(relay, key, "1.2", first)
            with sync_playwright() as playwright:
                relay.client = "page"
                use_page(relay, launch(playwright), password, api.drone(second)["name"])
            wire_curl.guess(curl)
        finally:
            relay.close()
            simulator.stop()
            server.stop()
        wire_files.write(relay.exchanges, folder, {key: "<local-key>", password: "<first-password>"})
    return len(relay.exchanges)


if __name__ == "__main__":
    print(f"{record(Path(sys.argv[1]))} exchanges")
