"""The PHP SOAP proxy before a server: judged by REST and by the server's own record."""

import os
import secrets
import socket
import subprocess
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import NamedTuple

import pytest
import requests
from playwright.sync_api import Browser

from dronemap_e2e.api import Api, Json
from dronemap_e2e.cuttable_proxy import CuttableProxy
from dronemap_e2e.ground_station import new_user
from dronemap_e2e.php_face import PhpSession
from dronemap_e2e.php_proxy import PhpProxy
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for


@pytest.fixture(scope="module")
def proxy(server: Server, tmp_path_factory: pytest.TempPathFactory) -> Iterator[PhpProxy]:
    started = PhpProxy(server.address, tmp_path_factory.mktemp("php"))
    started.start()
    yield started
    started.stop()


@pytest.fixture
def drone(api: Api, vehicles: Vehicles) -> Iterator[Json]:
    system_id = vehicles.wake_next()
    yield wait_for("the copter is ready", lambda: api.ready(system_id), 90)
    vehicles.silence(system_id)


def test_phpunit_against_the_server(server: Server, api: Api, proxy: PhpProxy, drone: Json) -> None:
    """End to end because PHP's own SOAP client, sessions and web server stand before a server as it ships."""
    viewer, first, own = f"viewer-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
    body = {"name": viewer, "password": first, "role": "viewer"}
    assert api.call("POST", "/users", body).status_code == 201
    session = Api(server.address)
    assert session.call("POST", "/session", {"name": viewer, "password": first}).ok
    assert session.call("POST", "/session/password", {"current": first, "next": own}).status_code == 204
    done = subprocess.run(
        ["phpunit", "--group", "server"],
        cwd=ROOT / "php-soap-proxy",
        env=os.environ
        | {
            "DRONEMAP_PHP_PROXY": proxy.address,
            "DRONEMAP_URL": server.address,
            "DRONEMAP_KEY": server.local_key(),
            "DRONEMAP_USER": viewer,
            "DRONEMAP_PASSWORD": own,
            "DRONEMAP_VIEWER_KEY": session.new_key("php", "viewer"),
            "DRONEMAP_DRONE": drone["id"],
        },
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stdout[-4000:]
    assert "OK (" in done.stdout


def commands(api: Api, drone: Json) -> list[str]:
    """Kinds of those that people gave: the cloud itself gives some when a drone is armed."""
    listed = api.get(f"/drones/{drone['id']}/commands")["commands"]
    return [one["type"] for one in listed if one["face"] != "rule"]


def test_lost_answer_is_told_as_not_known(server: Server, api: Api, drone: Json, tmp_path: Path) -> None:
    """End to end because a line is cut under a call that is on its way."""
    line = CuttableProxy(server.http_port)
    # The first description of the services takes a server longer than that patience.
    for service in ("ServerService", "MAVLinkControllerService"):
        assert requests.get(f"{server.address}/services/{service}?wsdl", timeout=60).ok
    proxy = PhpProxy(
        f"http://127.0.0.1:{line.port}", tmp_path, DRONEMAP_PHP_PATIENCE="4", PHP_CLI_SERVER_WORKERS="1"
    )
    proxy.start()
    try:
        session = PhpSession(proxy, {"key": server.local_key()})
        assert session.call("getDrone", {"droneId": drone["id"]}).ok
        own = {"droneId": drone["id"], "id": secrets.token_urlsafe(12)}
        line.cut()
        lost = session.call("arm", own)
        assert (lost.status_code, lost.json()["code"]) == (504, "proxy-server-timeout")
        assert "not known" in lost.json()["detail"]
        line.restore()
        # It was on its way: that is why nobody could have called it failed.
        wait_for("the vehicle is armed", lambda: api.drone(drone["id"])["armed"])
        again = session.call("arm", own | {"wait": 20})
        assert again.json()["outcome"]["result"] == "succeeded"
        assert commands(api, drone) == ["arm"]
    finally:
        line.close()
    gone = session.call("arm", {"droneId": drone["id"]})
    proxy.stop()
    assert (gone.status_code, gone.json()["code"]) == (502, "proxy-server-unreachable")
    assert "nothing was sent" in gone.json()["detail"]


class OtherSite(NamedTuple):
    """A page that is not the proxy's, at one address of another site and one of another port."""

    far: str
    near: str


@pytest.fixture
def other_site() -> Iterator[OtherSite]:
    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(b"<!doctype html><title>Another site</title>")

        def log_message(self, format: str, *args: object) -> None:
            return None

    site = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=site.serve_forever, daemon=True).start()
    port = site.server_address[1]
    yield OtherSite(f"http://localhost:{port}/", f"http://127.0.0.1:{port}/")
    site.shutdown()
    site.server_close()


# Each way in which a page can make a browser ask another site; told is what the page itself learns of it.
ATTACKS = """async ([address, drone, token]) => {
  const arm = `${address}/proxy.php?operation=arm&droneId=${drone}`;
  const told = {};
  const tried = async (name, ask) => {
    try {
      const answer = await ask();
      told[name] = `${answer.type} ${answer.status}`;
    } catch (error) {
      told[name] = 'blocked';
    }
  };
  await tried('simple', () => fetch(arm, {credentials: 'include', mode: 'no-cors'}));
  await tried('read', () => fetch(`${address}/proxy.php?operation=getDronesList`, {credentials: 'include'}));
  await tried('with token', () => fetch(arm, {credentials: 'include', headers: {'X-Dronemap-Token': token}}));
  await tried('json', () => fetch(arm, {credentials: 'include', method: 'POST', body: '{}',
      headers: {'Content-Type': 'application/json', 'X-Dronemap-Token': token}}));
  await tried('sign in', () => fetch(`${address}/session.php`,
      {credentials: 'include', method: 'POST', mode: 'no-cors', body: '{"key":"x"}'}));
  await new Promise((done) => {
    const picture = new Image();
    picture.onload = () => { told.picture = 'loaded'; done(); };
    picture.onerror = () => { told.picture = 'blocked'; done(); };
    picture.src = arm;
  });
  return told;
}"""


def test_page_of_another_site_cannot_use_it(
    browser: Browser, server: Server, api: Api, proxy: PhpProxy, drone: Json, other_site: OtherSite
) -> None:
    """End to end because a browser decides what it sends for pages of other sites, and shows them."""
    pilot = new_user(server, api, "operator")
    key = pilot.api.new_key("php", "operator")
    context = browser.new_context()
    page = context.new_page()
    page.goto(f"{proxy.address}/")
    signed_in = page.evaluate(
        """async (key) => (await (await fetch('session.php', {method: 'POST', body: JSON.stringify({key}),
             headers: {'Content-Type': 'application/json'}})).json())""",
        key,
    )
    token = signed_in["token"]
    for address in (other_site.far, other_site.near):
        page.goto(address)
        told = page.evaluate(ATTACKS, [proxy.address, drone["id"], token])
        assert told == {
            "simple": "blocked",
            "read": "blocked",
            "with token": "blocked",
            "json": "blocked",
            "sign in": "blocked",
            "picture": "blocked",
        }
    assert commands(api, drone) == []
    # The same browser on the proxy's own page may.
    page.goto(f"{proxy.address}/")
    own = page.evaluate(
        """async ([drone, token]) => (await fetch(`proxy.php?operation=arm&wait=20&droneId=${drone}`,
             {headers: {'X-Dronemap-Token': token}})).status""",
        [drone["id"], token],
    )
    assert own == 200
    assert commands(api, drone) == ["arm"]
    context.close()


def test_session_files_do_not_have_the_key(server: Server, api: Api, proxy: PhpProxy) -> None:
    """End to end because PHP writes its sessions to files of its own."""
    key = new_user(server, api, "operator").api.new_key("php", "operator")
    session = PhpSession(proxy, {"key": key})
    assert session.call("getDronesList", {}).ok
    kept = b"".join(file.read_bytes() for file in proxy.sessions.iterdir())
    assert b"sealed" in kept
    assert key.encode() not in kept
    assert str(session.browser.headers["X-Dronemap-Token"]).encode() not in kept


def test_it_listens_on_this_machine_alone(proxy: PhpProxy) -> None:
    """End to end because PHP's web server opens the port."""
    assert socket.create_connection(("127.0.0.1", proxy.port), 5)
    with pytest.raises(OSError):
        socket.create_connection(("127.0.0.2", proxy.port), 5)
