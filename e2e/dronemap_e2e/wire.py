"""Records requests of real clients to a server, in files: python -m dronemap_e2e.wire FOLDER

What the server answers is in the files too, and is what the test that replays them approves
(docs/how-to-add/wire.md). Needs curl, php with its soap extension, and chromium."""

import sys
import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

from . import wire_curl, wire_files
from .api import Api
from .runs import ready_drone
from .server import Server
from .simulator import QUICK_FLIGHT, Simulator
from .station import launch
from .waiting import wait_for
from .wire_clients import NEAR, Curl, call_operation, run_php, zeep_client
from .wire_page import use_page
from .wire_relay import RecordingRelay

CONTROLLER = "MAVLinkControllerService"
POINT = {"waypoint": NEAR}


def _by_curl(relay: RecordingRelay, curl: Curl) -> tuple[str, str]:
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


def _by_zeep(relay: RecordingRelay, key: str, drone: str) -> None:
    def client(service: str, version: str = "1.1") -> Any:
        return zeep_client(relay, key, version, service)

    controller = client(CONTROLLER)
    call_operation(controller, "getDronesList")
    call_operation(controller, "getDrone", droneId=drone)
    call_operation(controller, "getDrone", droneId=wire_curl.NOBODY)
    call_operation(controller, "setMode", droneId=drone, mode="NOSUCHMODE")
    call_operation(controller, "setHome", droneId=drone, latitude=47.3977, longitude=8.5456, altitude=488.0)
    call_operation(controller, "takePicture", droneId=drone)
    call_operation(controller, "setRelay", droneId=drone, relay=4, setting="toggle")
    call_operation(controller, "setRelay", droneId=drone, relay=400, setting="toggle")
    call_operation(controller, "listParameters", droneId=drone, search="NOSUCH")
    items = {"item": [POINT, {"waypoint": NEAR | {"holdSeconds": 2}}]}
    call_operation(controller, "uploadMission", droneId=drone, items=items)
    call_operation(controller, "takeControl", droneId=drone)
    call_operation(controller, "releaseControl", droneId=drone)
    planning = client("PlanningService")
    visits = {"item": [NEAR]}
    plan = call_operation(planning, "makePlan", drones={"item": [drone]}, waypoints=visits, seconds=0.1)
    if plan is not None:
        call_operation(planning, "removePlan", planId=plan.id)
    call_operation(
        client("VirtualDroneService"), "addVirtualDrone", name="An errand", items={"item": [POINT]}
    )
    call_operation(client("RecordService"), "listFlights", drone=wire_curl.NOBODY)
    call_operation(client("FleetService"), "listFleets")
    call_operation(zeep_client(relay, None, "1.1", CONTROLLER), "getDronesList")
    follower = client("FollowerService")
    place = {"latitude": 47.398, "longitude": 8.5456}
    follow = call_operation(follower, "followRequest", drone=drone, minutes=5, name="Ann", **place)
    if follow is not None:
        call_operation(follower, "getFollow", followId=follow.id)
        call_operation(follower, "cancelFollowRequest", followId=follow.id)
    newer = client(CONTROLLER, "1.2")
    call_operation(newer, "getDronesList")
    call_operation(newer, "getDrone", droneId=drone)
    call_operation(newer, "arm", droneId=wire_curl.NOBODY)


def record(folder: Path) -> int:
    """Records all exchanges; returns how many there are."""
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        server = Server(work / "data")
        server.start()
        address = f"udp://127.0.0.1:{server.udp_port}"
        simulator = Simulator(work / "sim.log", address, "--count", "2", *QUICK_FLIGHT)
        relay = RecordingRelay(server.http_port)
        try:
            key, password = server.local_key(), server.first_password()
            api = Api(server.address, key)
            wait_for("all is known", lambda: all(ready_drone(api, number) for number in (1, 2)), 150)
            curl = Curl(relay, key)
            first, second = _by_curl(relay, curl)
            _by_zeep(relay, key, first)
            run_php(relay, key, "1.1", first)
            run_php(relay, key, "1.2", first)
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
