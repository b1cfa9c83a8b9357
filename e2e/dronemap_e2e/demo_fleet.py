"""The server and the four simulated copters that `./dronemap up` starts, for the code blocks of documents."""

import os
import re
import subprocess
import sys
from pathlib import Path

from .api import Api, Json
from .php_proxy import PhpProxy
from .server import ROOT, Server
from .simulator import LOW_AND_QUICK_RETURN, Simulator
from .waiting import wait_for

COUNT = 4
HOME = "47.3977,8.5456"
SPEEDUP = "10"
FIRST_MODE = "STABILIZE"
SDK = ROOT / "sdk-typescript"
# What a page may have left behind: lists of REST, their member with the entries, what an entry is deleted by.
LEFTOVERS = (
    ("virtual-drones", "virtualDrones", "id"),
    ("zones", "features", "id"),
    ("missions", "missions", "id"),
    ("fleets", "fleets", "id"),
    ("groups", "groups", "id"),
    ("replays", "replays", "id"),
    ("users", "users", "name"),
)


class DemoFleet:
    """Ten times as fast as life, with everything else as the demo fleet has it."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.server = Server(folder / "data")
        self.server.start()
        self.api = Api(self.server.address, self.server.local_key())
        self._simulator = Simulator(
            folder / "sim.log",
            f"udp://127.0.0.1:{self.server.udp_port}",
            *("--count", str(COUNT), "--home", HOME),
            *("--speedup", SPEEDUP),
            *LOW_AND_QUICK_RETURN,
        )
        self._users = {user["name"] for user in self.api.get("/users")["users"]}
        self._programs = _programs(folder / "programs")
        self._packages = _packages(folder / "packages")
        wait_for("the copters are ready to arm", self._is_ready, 90)
        self._fly_once()
        self._php = PhpProxy(self.server.address, folder)
        self._php.start()

    def _fly_once(self) -> None:
        """So that there is a flight to look at for pages about flights, telemetry and recordings."""
        drone = self.api.drones()[0]["id"]
        self.api.do(drone, type="setMode", mode="GUIDED")
        self.api.do(drone, type="arm")
        self.api.do(drone, type="takeOff", altitude=5)
        self.api.do(drone, type="land")
        wait_for("it is down", self._all_down, 60)
        self._make_as_it_was(self.api.drone(drone))

    def _is_ready(self) -> bool:
        return all([self.api.ready(number) for number in range(1, COUNT + 1)])

    def close(self) -> None:
        self._php.stop()
        self._simulator.stop()
        self.server.stop()

    def mapped(self, text: str) -> str:
        """With the ports of this server where the documents have those of `./dronemap up`."""
        server = self.server
        ports = {
            "8080": server.http_port,
            "8081": server.stream_port,
            "8083": self._php.port,
            "14550": server.udp_port,
            "5760": server.tcp_port,
            "14560": server.outlet_udp_port,
            "5790": server.outlet_tcp_port,
            "25500": server.robot_udp_port,
            "9090": server.robot_web_port,
        }
        address = re.compile(rf"\b(127\.0\.0\.1|localhost):({'|'.join(ports)})\b")
        return address.sub(lambda found: f"{found[1]}:{ports[found[2]]}", text)

    def reader_folder(self, folder: Path) -> Path:
        """A fresh folder that looks like the checkout after `./dronemap up`, for one page."""
        folder.mkdir()
        hidden = (".git", ".data", ".tools")
        for entry in ROOT.iterdir():
            if entry.name not in hidden:
                (folder / entry.name).symlink_to(entry)
        (folder / ".data").symlink_to(self.server.data)
        (folder / "node_modules").symlink_to(self._packages)
        return folder

    def environment(self, home: Path) -> dict[str, str]:
        """A reader's who knows how to get a key; `home`: so that nothing of the developer's counts."""
        home.mkdir()
        # What HTTP refuses is an error of the block, and not only text.
        (home / ".curlrc").write_text("fail-with-body\nsilent\nshow-error\n")
        key = self.server.local_key()
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("DRONEMAP_")}
        return inherited | {
            "PATH": f"{self._programs}:{os.environ['PATH']}",
            "HOME": str(home),
            "PYTHONPATH": str(ROOT / "sdk-python"),
            "PYTHONDONTWRITEBYTECODE": "1",
            "MPLBACKEND": "agg",
            "DRONEMAP_URL": self.server.address,
            "DRONEMAP_KEY": key,
            "DRONEMAP_DATA_DIR": str(self.server.data),
            "DRONEMAP_HTTP_PORT": str(self.server.http_port),
            "DRONEMAP_STREAM_PORT": str(self.server.stream_port),
            "KEY": key,
            "API": f"{self.server.address}/api/v1",
        }

    def tidy_up(self) -> None:
        """Everything on the ground and nothing left of the page before."""
        for run in self.api.get("/runs")["runs"]:
            if run["state"] != "over":
                self.api.call("POST", f"/runs/{run['id']}/stop")
        for follow in self.api.get("/follows")["follows"]:
            if follow["state"] != "over":
                self.api.call("POST", f"/follows/{follow['id']}/stop")
        for drone in self.api.drones():
            self.api.call("DELETE", f"/warehouse/{drone['id']}")
        for path, member, name in LEFTOVERS:
            for entry in self.api.get(f"/{path}")[member]:
                if path != "users" or entry["name"] not in self._users:
                    self.api.call("DELETE", f"/{path}/{entry[name]}")
        wait_for("all drones are on the ground", self._all_down, 120)
        for drone in self.api.drones():
            self._make_as_it_was(drone)
        wait_for("the copters are ready to arm", self._is_ready, 90)

    def _all_down(self) -> bool:
        flying = [drone["id"] for drone in self.api.drones() if drone["armed"]]
        for drone in flying:
            self._send_home(drone)
        return not flying

    def _send_home(self, drone: str) -> None:
        if self.api.drone(drone)["mode"] in ("RTL", "LAND"):
            return
        body = {"type": "returnToLaunch"}
        if self.api.call("POST", f"/drones/{drone}/commands", body).status_code == 409:
            self.api.call("POST", f"/drones/{drone}/control/take-over", {"reason": "The page is over."})

    def _make_as_it_was(self, drone: Json) -> None:
        id, name = drone["id"], f"ArduCopter {drone['link']['systemId']}"
        if drone["name"] != name:
            self.api.call("PATCH", f"/drones/{id}", {"name": name})
        if drone["mode"] != FIRST_MODE:
            self.api.do(id, type="setMode", mode=FIRST_MODE)
        self.api.call("DELETE", f"/drones/{id}/control")


def _programs(folder: Path) -> Path:
    """The command line as pip installs it, and the Python that has the client."""
    folder.mkdir()
    lines = {
        "dronectl": f'exec "{sys.executable}" -m dronectl "$@"',
        "python3": f'exec "{sys.executable}" "$@"',
        "python": f'exec "{sys.executable}" "$@"',
        # Reads to the end, so that whatever writes into it does not fail, which a reader would never see.
        "head": '/usr/bin/head "$@"; status=$?; cat > /dev/null; exit $status',
    }
    for name, line in lines.items():
        (folder / name).write_text(f"#!/bin/sh\n{line}\n")
        (folder / name).chmod(0o755)
    return folder


def _packages(folder: Path) -> Path:
    """What `npm install` of the client makes of a project, with the client as its sources have it."""
    installed = SDK / "node_modules"
    if not (installed / ".bin" / "tsx").exists():
        subprocess.run(["npm", "ci", "--no-audit", "--no-fund"], cwd=SDK, check=True, capture_output=True)
    folder.mkdir()
    for name in ("ws", "tsx", "typescript", ".bin"):
        (folder / name).symlink_to(installed / name)
    client = folder / "@dronemap" / "client"
    client.mkdir(parents=True)
    (client / "src").symlink_to(SDK / "src")
    (client / "package.json").write_text(
        '{"name": "@dronemap/client", "type": "module", "exports": "./src/index.ts"}\n'
    )
    return folder
