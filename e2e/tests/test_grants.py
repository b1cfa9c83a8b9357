"""What is granted and taken back on the page takes effect on an open stream; at desk and phone."""

import json
import secrets
import time
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, expect, sync_playwright
from websockets.sync.client import ClientConnection, connect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.station import Hands, Pointer, Station, Touch, launch

PATIENCE = 30_000
SECONDS = 30


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        started = launch(playwright)
        yield started
        started.close()


def heard(stream: ClientConnection, kind: str, drone: str) -> None:
    """Waits for a message of that kind about that drone."""
    deadline = time.monotonic() + SECONDS
    while time.monotonic() < deadline:
        message = json.loads(stream.recv(timeout=SECONDS))
        if message["type"] == kind and drone in json.dumps(message):
            return
    raise AssertionError(f"no {kind} of {drone} within {SECONDS} s")


def silent(stream: ClientConnection, drone: str, seconds: float) -> None:
    """Nothing that names that drone comes."""
    deadline = time.monotonic() + seconds
    while (left := deadline - time.monotonic()) > 0:
        try:
            assert drone not in str(stream.recv(timeout=left))
        except TimeoutError:
            return


@pytest.mark.parametrize(
    ("size", "touch"),
    [pytest.param((1440, 900), False, id="desk"), pytest.param((390, 844), True, id="phone")],
)
def test_a_grant_shows_a_drone_and_taking_it_back_silences_the_open_stream(
    server: Server, api: Api, copter: Json, browser: Browser, size: tuple[int, int], touch: bool
) -> None:
    users = {}
    for role in ("administrator", "operator"):
        name, password = f"{role}-{secrets.token_hex(4)}", secrets.token_hex(10)
        body = {"name": name, "password": password, "role": role}
        assert api.call("POST", "/users", body).status_code == 201
        users[role] = (name, password)
    ann, first = users["operator"]
    session, own = Api(server.address), secrets.token_hex(10)
    assert session.call("POST", "/session", {"name": ann, "password": first}).ok
    change = {"current": first, "next": own}
    assert session.call("POST", "/session/password", change).status_code == 204
    key = session.new_key("watch", "operator")
    assert api.call("PUT", f"/users/{ann}/only-granted", {"onlyGranted": True}).status_code == 204

    context = browser.new_context(
        viewport={"width": size[0], "height": size[1]}, has_touch=touch, is_mobile=touch
    )
    hands: Hands = Touch() if touch else Pointer()
    chief = Station(context.new_page(), hands)
    chief.sign_in(server.address, *users["administrator"], secrets.token_hex(10))
    chief.press(f"Account of {users['administrator'][0]}")
    chief.press("Administration")
    card = chief.page.get_by_role("region", name="Who may see what")
    expect(card.get_by_text("Sees no drone: nothing is granted.").first).to_be_visible()

    headers = {"Authorization": f"Bearer {key}"}
    with connect(f"ws://127.0.0.1:{server.stream_port}/stream", additional_headers=headers) as stream:
        silent(stream, copter["id"], 1)
        card.get_by_label("Whom").select_option(ann)
        card.get_by_label("With which drones").select_option("only some")
        card.get_by_label(copter["name"]).check()
        hands.press(chief.page, card.get_by_role("button", name="Grant", exact=True))
        heard(stream, "drone", copter["id"])

        row = card.get_by_role("listitem").filter(has_text=ann)
        expect(row).to_contain_text(copter["name"])
        hands.hold(chief.page, row.get_by_role("button", name="Take back"))
        heard(stream, "droneRemoved", copter["id"])
        silent(stream, copter["id"], 2)
        expect(row).to_contain_text("Sees no drone", timeout=PATIENCE)
    answer = Api(server.address, key).call("GET", f"/drones/{copter['id']}")
    assert answer.status_code == 404, answer.text
    assert answer.json()["detail"] == f"There is no drone {copter['id']}."
    context.close()


ROUNDS = 60
MOST_SECONDS = 1.0


@pytest.mark.soak
def test_a_grant_taken_back_silences_the_open_stream_within_a_second_each_time(
    server: Server, api: Api, copter: Json
) -> None:
    name, password = f"pilot-{secrets.token_hex(4)}", secrets.token_hex(10)
    body = {"name": name, "password": password, "role": "operator"}
    assert api.call("POST", "/users", body).status_code == 201
    session, own = Api(server.address), secrets.token_hex(10)
    assert session.call("POST", "/session", {"name": name, "password": password}).ok
    assert session.call("POST", "/session/password", {"current": password, "next": own}).status_code == 204
    assert api.call("PUT", f"/users/{name}/only-granted", {"onlyGranted": True}).status_code == 204
    headers = {"Authorization": f"Bearer {session.new_key('watch', 'operator')}"}
    view, delays = {"operations": ["view"]}, []
    with connect(f"ws://127.0.0.1:{server.stream_port}/stream", additional_headers=headers) as stream:
        for _ in range(ROUNDS):
            answer = api.call("POST", "/grants", {"user": name, "drones": [copter["id"]]} | view)
            assert answer.status_code == 201, answer.text
            heard(stream, "drone", copter["id"])
            asked = time.monotonic()
            assert api.call("DELETE", f"/grants/{answer.json()['id']}").status_code == 204
            heard(stream, "droneRemoved", copter["id"])
            delays.append(time.monotonic() - asked)
            # It talks several times a second, so that whatever still came would come by then.
            silent(stream, copter["id"], 0.5)
    delays.sort()
    print(
        f"{ROUNDS} grants taken back: half within {delays[ROUNDS // 2]:.3f} s, all within {delays[-1]:.3f} s"
    )
    assert delays[-1] < MOST_SECONDS
