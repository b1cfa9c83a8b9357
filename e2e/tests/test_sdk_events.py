"""Events made while the server is killed and started again, read by a program that does nothing about it."""

import threading
from collections.abc import Iterator
from datetime import datetime, timedelta
from pathlib import Path

import pytest
import requests
from dronemap import Dronemap, EventGap, NumberedEvent

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

COUNT = 1000
KILLED_AFTER = (200, 450, 700)


@pytest.fixture
def flown_server(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[Server, str]]:
    """A server whose data are where programs look for the key of their own machine; the id of a copter."""
    monkeypatch.chdir(tmp_path)
    server = Server(tmp_path / ".data")
    server.start()
    vehicles = Vehicles(server, tmp_path / "sim.log")
    try:
        system_id = vehicles.wake_next()
        api = Api(server.address, server.local_key())
        drone = wait_for("the copter is ready", lambda: api.ready(system_id), 90)
        yield server, drone["id"]
    finally:
        vehicles.close()
        server.stop()


class Maker:
    """Makes one event after the other, each under a number of its own, until the server has taken it."""

    def __init__(self, server: Server, drone: str) -> None:
        self._address = f"{server.address}/api/v1/drones/{drone}/commands"
        key = Api(server.address, server.local_key()).new_key("maker", "administrator")
        self._session = requests.Session()
        self._session.headers["Authorization"] = f"Bearer {key}"
        self.made = 0
        self.reached = {count: threading.Event() for count in (*KILLED_AFTER, COUNT)}
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        for number in range(COUNT):
            while not self._taken(number):
                pass
            self.made += 1
            if self.made in self.reached:
                self.reached[self.made].set()

    def _taken(self, number: int) -> bool:
        """409: it was judged, and refused."""
        body = {"type": "readHome", "id": name_of(number)}
        try:
            answer = self._session.post(self._address, json=body, timeout=10)
        except requests.RequestException:
            return False
        assert answer.status_code in (200, 202, 409, 429, 503), answer.text
        return answer.status_code in (200, 202, 409)


def name_of(number: int) -> str:
    return f"event-{number:04}"


class Reader:
    """Reads events for as long as the test lasts."""

    def __init__(self, server: Server, drone: str) -> None:
        self.read: list[NumberedEvent | EventGap] = []
        self._connected = Dronemap.connect(server.address)
        self._events = self._connected.events(drones=[drone])
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        for event in self._events:
            self.read.append(event)

    @property
    def events(self) -> list[NumberedEvent]:
        return [event for event in self.read if isinstance(event, NumberedEvent)]

    def commands(self) -> set[str | None]:
        return {event.command for event in self.events}

    @property
    def gaps(self) -> list[EventGap]:
        return [gap for gap in self.read if isinstance(gap, EventGap)]


def test_each_event_is_read_or_in_a_gap_that_the_store_confirms(
    flown_server: tuple[Server, str],
) -> None:
    """End to end because a server process is killed over its database while a program reads."""
    server, drone = flown_server
    reader = Reader(server, drone)
    maker = Maker(server, drone)
    for count in KILLED_AFTER:
        assert maker.reached[count].wait(120)
        server.kill()
        server.start()
    assert maker.reached[COUNT].wait(120)

    api = Api(server.address, server.local_key())
    wait_for("the last one is read", lambda: name_of(COUNT - 1) in reader.commands(), 60)
    wait_for("all that is stored is read", lambda: stored_commands(api, drone) <= reader.commands(), 60)
    numbers = [event.number for event in reader.events]
    assert numbers == sorted(set(numbers))
    read = reader.commands()
    missing = [name_of(number) for number in range(COUNT) if name_of(number) not in read]
    stored = stored_events(api, drone)
    print(f"{len(read)} read, {len(missing)} missing, {len(reader.gaps)} gaps")
    assert len(reader.gaps) <= len(KILLED_AFTER)
    for gap in reader.gaps:
        assert gap.cause == "serverEnded"
        assert gap.from_ is not None and gap.until is not None
        assert not [each for each in stored if gap.from_ < datetime.fromisoformat(each["at"]) < gap.until]
    for name in missing:
        at = datetime.fromisoformat(api.get(f"/commands/{name}")["at"])
        assert any(covers(gap, at) for gap in reader.gaps), f"{name} of {at} lies in no gap"


def stored_commands(api: Api, drone: str) -> set[str]:
    return {event["command"] for event in stored_events(api, drone)}


def covers(gap: EventGap, at: datetime) -> bool:
    assert gap.from_ is not None and gap.until is not None
    return gap.from_ - timedelta(milliseconds=1) <= at <= gap.until


def stored_events(api: Api, drone: str) -> list[dict[str, str]]:
    """By another operation than the one that was followed."""
    events: list[dict[str, str]] = api.get(f"/drones/{drone}/events?most=20000")["events"]
    return events
