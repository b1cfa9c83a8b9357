"""Records what real clients say to a server, in files: python -m dronemap_e2e.wire FOLDER

What the server answers is in the files too, and is what the test that replays them approves
(docs/how-to-add/wire.md). Needs curl, php with its soap extension, and chromium."""

import sys
import tempfile
from pathlib import Path
from typing import Any

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
from .wire_relay import ReliefTrial

CONTROLLER = "MAVLinkControllerService"
POINT = {"waypoint": NEAR}


def _by_curl(relay: ReliefTrial, curl: Curl) -> tuple[str, str]:
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


def _by_zeep(relay: ReliefTrial, key: str, drone: str) -> None:
    def client(service: str, version: str = "1.1") -> Any:
        return zeep_client(relay, key, version, service)

    controller = client(CONTROLLER)
    called(controller, "getDronesList")
    called(controller, "getDrone", droneId=drone)
    called(controller, "getDrone", droneId=wire_curl.NOBODY)
    called(controller, "setMode", droneId=drone, mode="NOSUCHMODE")
    called(controller, "setHome", droneId=drone, latitude=47.3977, longitude=8.5456, altitude=488.0)
    called(controller, "takePicture", droneId=drone)
    called(controller, "setRelay", droneId=drone, relay=4, setting="toggle")
    called(controller, "setRelay", droneId=drone, relay=400, setting="toggle")
    called(controller, "listParameters", droneId=drone, search="NOSUCH")
    items = {"item": [POINT, {"waypoint": NEAR | {"holdSeconds": 2}}]}
    called(controller, "uploadMission", droneId=drone, items=items)
    called(controller, "takeControl", droneId=drone)
    called(controller, "releaseControl", droneId=drone)
    planning = client("PlanningService")
    visits = {"item": [NEAR]}
    plan = called(planning, "makePlan", drones={"item": [drone]}, waypoints=visits, seconds=0.1)
    if plan is not None:
        called(planning, "removePlan", planId=plan.id)
    called(client("VirtualDroneService"), "addVirtualDrone", name="An errand", items={"item": [POINT]})
    called(client("RecordService"), "listFlights", drone=wire_curl.NOBODY)
    called(client("FleetService"), "listFleets")
    called(zeep_client(relay, None, "1.1", CONTROLLER), "getDronesList")
    follower = client("FollowerService")
    place = {"latitude": 47.398, "longitude": 8.5456}
    follow = called(follower, "followRequest", drone=drone, minutes=5, name="Ann", **place)
    if follow is not None:
        called(follower, "getFollow", followId=follow.id)
        called(follower, "cancelFollowRequest", followId=follow.id)
    newer = client(CONTROLLER, "1.2")
    called(newer, "getDronesList")
    called(newer, "getDrone", droneId=drone)
    called(newer, "arm", droneId=wire_curl.NOBODY)


def record(folder: Path) -> int:
    """Records all exchanges; returns how many there are."""
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        server = Server(work / "data")
        server.start()
        address = f"udp://127.0.0.1:{server.udp_port}"
        simulator = Simulator(work / "sim.log", address, "--count", "2", *QUICK_FLIGHT)
        relay = ReliefTrial(server.http_port)
        try:
            key, password = server.local_key(), server.first_password()
            api = Api(server.address, key)
            wait_for("all is known", lambda: all(known(api, number) for number in (1, 2)), 150)
            curl = Curl(relay, key)
            first, second = _by_curl(relay, curl)
            _by_zeep(relay, key, first)
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
