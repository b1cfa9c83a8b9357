"""Programs for the original Dronemap Planner know nothing but the addresses that it printed."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

import pytest
import requests
import zeep
import zeep.exceptions
import zeep.transports
from requests import Session

from dronemap_e2e.api import Api
from dronemap_e2e.flight import Point
from dronemap_e2e.frame_links import Bridge, WebSocketLink
from dronemap_e2e.ports import own_host
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import QUICK_FLIGHT, Simulator
from dronemap_e2e.waiting import wait_for

BY_UDP, BY_WEB_SOCKET = 1, 2
METERS_PER_DEGREE = 111_195
TAKE_OFF_METERS = 10.0
PATIENCE = 30.0
CONTROLLER = "3030/MAVLinkControllerService"
APPLICATIONS = "10500/ApplicationsService"
ROBOTS = "7070/RSOLinkCloudManagementService"


class OriginalProgram:
    """Somebody's program: it knows a host, addresses as they were printed, names of operations, and a key."""

    def __init__(self, host: str, key: str | None) -> None:
        self._host = host
        self._key = key
        self.controller = self.service(CONTROLLER)
        self.applications = self.service(APPLICATIONS)
        self.robots = self.service(ROBOTS)

    def service(self, address: str) -> Any:
        session = Session()
        transport: Any = zeep.transports.Transport(session=session)  # type: ignore[no-untyped-call]
        client: Any = zeep.Client(f"http://{self._host}:{address}?wsdl", transport=transport)  # type: ignore[no-untyped-call]
        if self._key:
            session.headers["Authorization"] = f"Bearer {self._key}"
        return client.service

    def ready(self, system_id: int) -> Any:
        """The drone as it is listed, once it can be armed."""
        active = self.controller.getDronesList(active=True)
        drones = active["item"] if active else []
        return next((d for d in drones if d.link.systemId == system_id and d.readyToArm and d.home), None)

    def seen(self, drone: str) -> Point:
        active = self.controller.getDronesList(active=True)["item"]
        position = next(d.position for d in active if d.id == drone)
        return Point(position.latitude, position.longitude, position.altitudeAboveHome)


@dataclass(frozen=True)
class OriginalServer:
    """A server at the original addresses, with a copter at each of the two for vehicles."""

    server: Server
    key: str
    simulators: dict[int, Simulator]

    @property
    def program(self) -> OriginalProgram:
        return OriginalProgram(self.server.host, self.key)

    def place(self, system_id: int) -> Point:
        return Point(*self.simulators[system_id].place(system_id))


@pytest.fixture(scope="module")
def original_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[OriginalServer]:
    folder, host = tmp_path_factory.mktemp("original"), own_host()
    server = Server(
        folder / "data",
        DRONEMAP_BIND=host,
        DRONEMAP_ORIGINAL_ADDRESSES="true",
        DRONEMAP_ENDPOINTS=f"udpserver://{host}:14550,wsserver://{host}:8080",
    )
    server.start()
    key = Api(server.address, server.local_key()).new_key("a script of 2017", "operator")
    bridge = Bridge(WebSocketLink(8080, host, "/websockets/mavlink"))
    links = {BY_UDP: f"udp://{host}:14550", BY_WEB_SOCKET: f"udp://127.0.0.1:{bridge.port}"}
    simulators = {
        system_id: Simulator(folder / f"{system_id}.log", link, "--sysid", str(system_id), *QUICK_FLIGHT)
        for system_id, link in links.items()
    }
    yield OriginalServer(server, key, simulators)
    for simulator in simulators.values():
        simulator.stop()
    bridge.close()
    server.stop()


def fault(call: Any, **arguments: object) -> zeep.exceptions.Fault:
    with pytest.raises(zeep.exceptions.Fault) as raised:
        call(**arguments)
    return raised.value


def do(call: Any, **arguments: object) -> None:
    outcome = call(**arguments).outcome
    assert outcome.result == "succeeded", outcome


@pytest.mark.parametrize("system_id", [BY_UDP, BY_WEB_SOCKET])
def test_original_program_flies_a_drone(original_server: OriginalServer, system_id: int) -> None:
    """End to end because zeep, which knows only those addresses, flies what joined at those of vehicles."""
    controller = original_server.program.controller
    drone = wait_for("a drone is listed", lambda: original_server.program.ready(system_id), PATIENCE)
    start = original_server.place(system_id)
    do(controller.arm, droneId=drone.id)
    assert original_server.simulators[system_id].armed(system_id)
    do(controller.takeoff, droneId=drone.id, altitude=TAKE_OFF_METERS)
    wait_for("it is up", lambda: original_server.place(system_id).altitude > TAKE_OFF_METERS - 1, PATIENCE)

    there = Point(start.latitude + 20 / METERS_PER_DEGREE, start.longitude, 15.0)
    do(
        controller.goto,
        droneId=drone.id,
        latitude=there.latitude,
        longitude=there.longitude,
        altitude=there.altitude,
    )
    wait_for("it is there", lambda: _is_at(original_server.place(system_id), there), PATIENCE)
    wait_for("it is seen there", lambda: _is_at(original_server.program.seen(drone.id), there), PATIENCE)

    do(controller.land, droneId=drone.id)
    wait_for("its motors stop", lambda: not original_server.simulators[system_id].armed(system_id), PATIENCE)
    down = original_server.place(system_id)
    assert abs(down.altitude) < 0.5
    assert there.metres_to(down.latitude, down.longitude) < 3


def _is_at(here: Point, there: Point) -> bool:
    near = there.metres_to(here.latitude, here.longitude) < 2
    return near and abs(here.altitude - there.altitude) < 1


def test_original_program_requests_a_follow(original_server: OriginalServer) -> None:
    """End to end because zeep, which knows nothing but that address, reads each answer by its WSDL."""
    program = original_server.program
    drone = wait_for("a drone is listed", lambda: program.ready(BY_UDP), PATIENCE)
    phone = original_server.place(BY_UDP)
    near = {"latitude": phone.latitude + 30 / METERS_PER_DEGREE, "longitude": phone.longitude}

    asked = program.applications.followRequest(drone=drone.id, **near)
    assert asked.state == "allocated", asked
    now = datetime.now(UTC)
    positions = {"item": [{"at": now, "accuracy": 4, **near}]}
    program.applications.sendNewGPSLocation(followId=asked.id, sent=now, positions=positions)
    assert [f.id for f in program.applications.getFollowsList()["item"]] == [asked.id]
    assert program.applications.cancelFollowRequest(followId=asked.id).state == "over"
    assert not original_server.simulators[BY_UDP].armed(BY_UDP)


def test_original_program_gets_soap_faults(original_server: OriginalServer) -> None:
    """End to end because zeep, which knows nothing but those addresses, reads faults by their WSDLs."""
    program = original_server.program
    drone = wait_for("a drone is listed", lambda: program.ready(BY_UDP), PATIENCE)
    high = fault(program.controller.takeoff, droneId=drone.id, altitude=9000)
    assert "altitude" in high.message and "1 to 500 m" in high.message
    assert high.code.endswith(":Client")
    assert "nosuchdrone" in fault(program.controller.arm, droneId="nosuchdrone").message
    assert "latitude" in fault(program.applications.followRequest, latitude=95, longitude=8).message
    assert "administrator" in fault(program.robots.listEndpoints).message

    stranger = OriginalProgram(original_server.server.host, None)
    for call in (stranger.controller.getDronesList, stranger.applications.getFollowsList):
        assert "key" in fault(call).message
    assert "key" in fault(stranger.controller.arm, droneId=drone.id).message
    assert not original_server.simulators[BY_UDP].armed(BY_UDP)


def test_original_program_lists_endpoints(original_server: OriginalServer) -> None:
    """End to end because zeep, which knows nothing but that address, reads the answer by its WSDL."""
    listed = OriginalProgram(
        original_server.server.host, original_server.server.local_key()
    ).robots.listEndpoints()["item"]
    host = original_server.server.host
    ways = {(f"udpserver://{host}:14550", "open"), (f"wsserver://{host}:8080", "open")}
    assert {(e.url, e.state) for e in listed} >= ways


def test_original_ports_serve_rest_and_nothing_else(original_server: OriginalServer) -> None:
    """End to end because each of these ports is a socket of its own, of a server as it ships."""
    key = {"Authorization": f"Bearer {original_server.key}"}
    host = f"http://{original_server.server.host}"
    drones = requests.get(f"{host}:6060/api/v1/drones", headers=key, timeout=10)
    assert {drone["link"]["systemId"] for drone in drones.json()["drones"]} == {BY_UDP, BY_WEB_SOCKET}
    assert requests.get(f"{host}:6060/api/v1/drones", timeout=10).status_code == 401
    for address in (CONTROLLER, APPLICATIONS, ROBOTS):
        port, path = address.split("/")
        elsewhere = requests.get(f"{host}:{port}/api/v1/drones", headers=key, timeout=10)
        assert elsewhere.status_code == 404
        assert f"it has /{path}." in elsewhere.json()["detail"]
