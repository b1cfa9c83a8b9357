"""One user commands a drone at a time: judged at the vehicle's socket and on the page."""

import os
import secrets
import signal
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import NamedTuple

import pytest
from playwright.sync_api import Browser, Playwright, expect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.database_stall import DatabaseStall
from dronemap_e2e.race import (
    HoveringCopter,
    Racer,
    RestClient,
    StreamClient,
    check_epochs,
    fill_epochs_from_records,
    race,
)
from dronemap_e2e.screen import open_page
from dronemap_e2e.server import Server
from dronemap_e2e.station import Pointer, Station, launch
from dronemap_e2e.waiting import wait_for

LOITER, RTL, BRAKE = 5, 6, 17
SOAK_ROUNDS = 10_000


class User(NamedTuple):
    name: str
    password: str


class ControlServer(NamedTuple):
    """A server that has drones return soon after their holder is lost."""

    server: Server

    @property
    def api(self) -> Api:
        """An API client with the local key, which each start of the server makes anew."""
        return Api(self.server.address, self.server.local_key())

    def user(self, role: str) -> User:
        user = User(f"{role}-{secrets.token_hex(4)}", secrets.token_hex(10))
        body = {"name": user.name, "password": user.password, "role": role}
        answer = self.api.call("POST", "/users", body)
        assert answer.status_code == 201, answer.text
        return user

    def key(self, role: str) -> str:
        """A key of a new user, whose password is their own."""
        user = self.user(role)
        session = Api(self.server.address)
        own = secrets.token_hex(10)
        credentials = {"name": user.name, "password": user.password}
        assert session.call("POST", "/session", credentials).ok
        change = {"current": user.password, "next": own}
        assert session.call("POST", "/session/password", change).status_code == 204
        return session.new_key("race", role)


@pytest.fixture(scope="module")
def control_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ControlServer]:
    server = Server(
        tmp_path_factory.mktemp("control") / "data",
        DRONEMAP_CONTROL_RETURN_SECONDS="2",
        DRONEMAP_RATE_COMMANDS="0",  # racers are no people
    )
    server.start()
    yield ControlServer(server)
    server.stop()


@pytest.fixture
def hovering_copter(control_server: ControlServer) -> Iterator[Callable[[], tuple[HoveringCopter, str]]]:
    """Makes drones that hover, guided."""
    flying: list[HoveringCopter] = []

    def make() -> tuple[HoveringCopter, str]:
        hovering = HoveringCopter(control_server.server.udp_port, 50 + len(flying))
        flying.append(hovering)
        drone = wait_for("it flies", lambda: _flying(control_server.api, hovering.peer.port), 60)
        # On the page those of earlier tests, lost by now, would else be called the same.
        name = {"name": f"Hoverer {hovering.peer.port}"}
        assert control_server.api.call("PATCH", f"/drones/{drone['id']}", name).ok
        return hovering, drone["id"]

    yield make
    for hovering in flying:
        hovering.peer.close()


def _flying(api: Api, port: int) -> Json | None:
    return next(
        (
            d
            for d in api.drones()
            if d["link"]["port"] == port and d["flight"] == "inAir" and d["actions"]["goTo"]["allowed"]
        ),
        None,
    )


def racers(control_server: ControlServer, drone: str, quiet_every: int = 8) -> list[Racer]:
    stream = StreamClient(control_server.server.stream_address, control_server.key("supervisor"), drone)
    rest = RestClient(Api(control_server.server.address, control_server.key("supervisor")), drone)
    return [
        Racer("rest", rest, 0, seed=1, quiet_every=quiet_every),
        Racer("stream", stream, 1, seed=2, quiet_every=quiet_every),
    ]


def command_record(control_server: ControlServer, command: str) -> Json | None:
    answer = control_server.api.call("GET", f"/commands/{command}")
    found: Json | None = answer.json() if answer.ok else None
    return found


@pytest.mark.soak
def test_no_command_of_an_old_epoch_in_ten_thousand_rounds_with_restarts(
    control_server: ControlServer, hovering_copter: Callable[[], tuple[HoveringCopter, str]]
) -> None:
    hovering, drone = hovering_copter()
    both = racers(control_server, drone, quiet_every=100)

    def restart(round_number: int) -> None:
        if round_number and round_number % (SOAK_ROUNDS // 4) == 0:
            control_server.server.kill()
            control_server.server.start()
            wait_for("it flies again", lambda: _flying(control_server.api, hovering.peer.port), 60)

    with DatabaseStall(control_server.server.data, seed=4) as stall:
        race(both, SOAK_ROUNDS, restart)

    moves = list(hovering.moves)
    lost = fill_epochs_from_records(moves, both, partial(command_record, control_server))
    changes = check_epochs(moves, both)
    refused = sum(len(racer.refused) for racer in both)
    print(
        f"{len(moves)} commands on the wire, {changes} changes of the holder between them, {refused} refused,"
    )
    print(f"{stall.times} stalls; the answer of {lost} was lost in a crash")
    assert changes > SOAK_ROUNDS / 100 and stall.times > SOAK_ROUNDS / 100


def holds_and_returns(control_server: ControlServer, hovering: HoveringCopter, drone: str) -> None:
    wait_for("it holds", lambda: hovering.peer.state.custom_mode in (LOITER, BRAKE), 60)
    wait_for("it returns", lambda: hovering.peer.state.custom_mode == RTL, 60)
    assert control_server.api.drone(drone)["control"]["state"] == "free"
    assert [c["by"] for c in control_server.api.get(f"/drones/{drone}/commands")["commands"][:2]] == [
        "dronemap"
    ] * 2


def kill_browser(mark: str) -> None:
    """Its first process, which all others end with; kill -9."""
    for folder in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            arguments = (folder / "cmdline").read_bytes().split(b"\0")
            if mark.encode() in arguments and not any(each.startswith(b"--type=") for each in arguments):
                os.kill(int(folder.name), signal.SIGKILL)
                return
    raise AssertionError("there is no such browser")


def test_drone_holds_and_returns_after_browser_is_killed(
    control_server: ControlServer,
    hovering_copter: Callable[[], tuple[HoveringCopter, str]],
    playwright: Playwright,
) -> None:
    """End to end because a browser that is killed says nothing more, and its real connection is what ends."""
    hovering, drone = hovering_copter()
    mark = f"--doomed={secrets.token_hex(8)}"
    doomed = launch(playwright, mark)
    station = Station(open_page(doomed), Pointer())
    station.sign_in(control_server.server.address, *control_server.user("operator"), secrets.token_hex(10))
    station.choose(control_server.api.drone(drone)["name"])
    station.press("Take control")
    station.shows("You have control")
    wait_for("the page keeps it", lambda: control_server.api.drone(drone)["control"]["explicit"], 30)

    kill_browser(mark)

    holds_and_returns(control_server, hovering, drone)


def test_page_shows_holder_and_hands_over_control(
    control_server: ControlServer, hovering_copter: Callable[[], tuple[HoveringCopter, str]], browser: Browser
) -> None:
    """End to end because people do it on the page, each in a browser of their own."""
    _, drone = hovering_copter()
    name = control_server.api.drone(drone)["name"]
    users = [control_server.user("operator"), control_server.user("operator")]
    ann, bob = (Station(open_page(browser), Pointer()) for _ in users)
    for station, user in zip((ann, bob), users, strict=True):
        station.sign_in(control_server.server.address, *user, secrets.token_hex(10))
        station.choose(name)

    ann.press("Take control")
    bob.shows(f"{users[0].name} has control")
    expect(bob.button("Hold")).to_have_attribute("aria-disabled", "true")
    bob.press("Ask for control")
    ann.press("Grant")
    bob.shows("You have control")
    ann.shows(f"{users[1].name} has control")
    bob.press("Keep control")
    bob.press("Give back")
    ann.shows("Nobody has control")
    ann.press("Take control")
    ann.page.context.close()
    bob.shows("Nobody has control", 60)
    bob.page.context.close()
