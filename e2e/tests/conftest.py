"""The server and vehicles that tests share."""

import itertools
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Playwright, sync_playwright

from dronemap_e2e.api import Api, Json
from dronemap_e2e.copter import Copter
from dronemap_e2e.demo_fleet import DemoFleet
from dronemap_e2e.ground_station import Attach, GroundStation, User
from dronemap_e2e.message_recorder import MessageRecorder, VehicleMessages
from dronemap_e2e.server import Server
from dronemap_e2e.station import launch
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

# A vehicle of its own for every test, so that no test takes another one's for its own.
SYSTEM_IDS = itertools.count(10)
HARDWARE = itertools.count(5001)
# The files that take longest begin first, or one process is still at them when the others have nothing left.
LONGEST = (
    "test_code_blocks_of_command_line",
    "test_flight_in_browser",
    "test_follow_in_browser",
    "test_accounts_in_browser",
    "test_flights_and_failures",
    "test_crash",
    "test_control_loss",
    "test_flight_by_program",
    "test_plans_in_browser",
    "test_control",
    "test_robot_in_browser",
    "test_parameters_in_browser",
    "test_link_quality",
    "test_zones_in_browser",
    "test_links",
    "test_grants",
    "test_other_vehicles",
    "test_durability",
    "test_ros1",
    "test_flights",
    "test_errors_in_browser",
    "test_outlet_tools",
    "test_canaries",
    "test_protection",
)


# One of these is said by each test that is no long one: why nothing less than whole programs can show it.
REASONS = ("End to end because ", "Of the judge alone: ")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        docstring = getattr(item, "function", None).__doc__ or ""
        if not any(reason in docstring for reason in REASONS) and item.get_closest_marker("soak") is None:
            raise pytest.UsageError(
                f"{item.nodeid} says not why it is an end-to-end test: say in its docstring "
                f'"{REASONS[0]}…", or fly it in the laboratory (docs/how-to-add/flight.md)'
            )
    places = {name: place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: places.get(item.path.stem, len(LONGEST)))


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server that all tests share which do not break it."""
    started = Server(tmp_path_factory.mktemp("server") / "data")
    started.start()
    yield started
    started.stop()


@pytest.fixture(scope="session")
def api(server: Server) -> Api:
    return Api(server.address, server.local_key())


@pytest.fixture(scope="session")
def restartable_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server that the tests share which break one; `killable_server` makes sure that it runs."""
    server = Server(tmp_path_factory.mktemp("fallen") / "data")
    yield server
    server.stop()


@pytest.fixture
def killable_server(restartable_server: Server) -> Server:
    """One that the test may kill, stop and start again; it knows the drones and users of other such tests."""
    restartable_server.start_unless_it_runs()
    return restartable_server


@pytest.fixture
def own_server(tmp_path: Path) -> Iterator[Server]:
    """One that the test may kill, with fresh data."""
    started = Server(tmp_path / "data")
    started.start()
    yield started
    started.stop()


@pytest.fixture
def recorder(server: Server) -> Iterator[MessageRecorder]:
    """A message recorder before the shared server."""
    opened = MessageRecorder(server.udp_port)
    yield opened
    opened.close()


@pytest.fixture(scope="session")
def vehicles(server: Server, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Vehicles]:
    started = Vehicles(server, tmp_path_factory.mktemp("vehicles") / "sim.log")
    yield started
    started.close()


@pytest.fixture
def system_id(vehicles: Vehicles) -> Iterator[int]:
    """System id of a copter that only this test has."""
    taken = vehicles.wake_next()
    yield taken
    vehicles.silence(taken)


@pytest.fixture
def wire(vehicles: Vehicles, system_id: int) -> VehicleMessages:
    """Messages from and to the test's copter."""
    return vehicles.wire(system_id)


@pytest.fixture
def copter(api: Api, system_id: int) -> Json:
    """The test's copter, five times as fast as life: the drone as the server lists it."""
    return wait_for("the copter is listed, with a home, and ready to arm", lambda: api.ready(system_id), 90)


@pytest.fixture(scope="module")
def demo_fleet(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DemoFleet]:
    """What `./dronemap up` starts, for code blocks of documents."""
    started = DemoFleet(tmp_path_factory.mktemp("demo"))
    yield started
    started.close()


@pytest.fixture(scope="session")
def playwright() -> Iterator[Playwright]:
    """The one of this worker: there cannot be two at a time."""
    with sync_playwright() as started:
        yield started


@pytest.fixture(scope="session")
def browser(playwright: Playwright) -> Iterator[Browser]:
    """One for each worker; each test has contexts of its own."""
    started = launch(playwright)
    yield started
    started.close()


@pytest.fixture(scope="module")
def copters(server: Server, api: Api, tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[Copter]]:
    """Two, both of which call themselves system 1."""
    folder = tmp_path_factory.mktemp("copters")
    made = [Copter(server, api, folder / f"{number}.log", next(HARDWARE)) for number in range(2)]
    yield made
    for one in made:
        one.close()


@pytest.fixture
def attach(server: Server) -> Iterator[Attach]:
    """Attaches ground stations to the outlet, until the test is over."""
    attached: list[GroundStation] = []

    def make(user: User | None, tcp: bool = True, **options: Any) -> GroundStation:
        port = server.outlet_tcp_port if tcp else server.outlet_udp_port
        address = f"{'tcp' if tcp else 'udpout'}:127.0.0.1:{port}"
        attached.append(GroundStation(address, user.passphrase if user else None, **options))
        return attached[-1]

    yield make
    for ground in attached:
        ground.close()
