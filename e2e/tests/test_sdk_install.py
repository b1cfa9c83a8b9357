"""The wheel of the Python client, installed without a network into an environment that has nothing else."""

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.waiting import wait_for

SDK = ROOT / "sdk-python"
TYPESCRIPT = ROOT / "sdk-typescript"
FLIGHT = """
import sys
from dronemap import Dronemap
import dronemap
assert dronemap.__file__.startswith(sys.prefix), dronemap.__file__
with Dronemap.connect() as server, server.drone(sys.argv[1]).control() as drone:
    drone.arm()
    drone.take_off(6)
    drone.return_home()
"""
NODE_FLIGHT = """
import { Dronemap } from '@dronemap/client';
import { WebSocket } from 'ws';

const { DRONEMAP_URL: url, DRONEMAP_KEY: key } = process.env;
const dronemap = await Dronemap.connect({ url, key, WebSocket });
const drone = await dronemap.drone(process.argv[2]);
await drone.control(async () => {
  await (await drone.command({ type: 'arm' })).outcome();
  await (await drone.command({ type: 'takeOff', altitude: 6 })).outcome();
  await drone.waitFor(({ position }) => position.altitudeAboveHome > 5, { timeout: 60_000 });
});
dronemap.close();
"""


def test_wheel_installs_offline_and_flies(server: Server, api: Api, copter: Json, tmp_path: Path) -> None:
    """End to end because a wheel is built, installed into a clean environment, and flies a copter."""
    wheels = tmp_path / "wheels"
    pip = (sys.executable, "-m", "pip", "--quiet")
    run(*pip, "wheel", "--no-deps", "--wheel-dir", wheels, sources(tmp_path))
    run(*pip, "download", "--dest", wheels, *pinned_dependencies())
    run(sys.executable, "-m", "venv", tmp_path / "clean")
    clean = tmp_path / "clean" / "bin"
    # Without a network: a process of its own network namespace has none.
    offline = ("unshare", "--net") if os.geteuid() == 0 else ()
    run(*offline, clean / "pip", "install", "--quiet", "--no-index", "--find-links", wheels, "dronemap")

    environment = {
        "DRONEMAP_URL": server.address,
        "DRONEMAP_KEY": server.local_key(),
        "PATH": os.environ["PATH"],
    }
    run(clean / "python", "-c", FLIGHT, copter["id"], cwd=tmp_path, env=environment)
    told = run(clean / "dronectl", "drones", "--json", cwd=tmp_path, env=environment)

    assert copter["id"] in told
    history = api.get(f"/drones/{copter['id']}/commands")["commands"]
    done = {command["type"]: command["outcome"]["result"] for command in history}
    assert done.items() >= {"arm": "succeeded", "takeOff": "succeeded", "returnToLaunch": "succeeded"}.items()


def test_tarball_installs_offline_and_flies(server: Server, api: Api, copter: Json, tmp_path: Path) -> None:
    """End to end because a tarball is made, installed into an empty folder, and flies a copter in Node."""
    # Node before version 22 has no WebSocket of its own: a program brings the one that it likes.
    packages = [TYPESCRIPT, TYPESCRIPT / "node_modules" / "ws"]
    run("npm", "pack", "--silent", "--pack-destination", tmp_path, *packages, cwd=TYPESCRIPT)
    clean = tmp_path / "clean"
    clean.mkdir()
    offline = ("unshare", "--net") if os.geteuid() == 0 else ()
    tarballs = sorted(tmp_path.glob("*.tgz"))
    run(*offline, "npm", "install", "--silent", "--offline", "--no-audit", *tarballs, cwd=clean)
    (clean / "fly.mjs").write_text(NODE_FLIGHT)

    named = {"DRONEMAP_URL": server.address, "DRONEMAP_KEY": server.local_key()}
    run("node", "fly.mjs", copter["id"], cwd=clean, env=os.environ | named)

    wait_for("it landed and disarmed", lambda: api.drone(copter["id"])["armed"] is False, 60)
    history = api.get(f"/drones/{copter['id']}/commands")["commands"]
    done = {command["type"]: command["outcome"]["result"] for command in history}
    assert done.items() >= {"arm": "succeeded", "takeOff": "succeeded", "returnToLaunch": "succeeded"}.items()


def sources(folder: Path) -> Path:
    """A copy, since a build leaves files behind."""
    copied = folder / "sources"
    run("cp", "--archive", SDK, copied)
    return copied


def pinned_dependencies() -> list[str]:
    pins = dict(line.split("==") for line in (ROOT / "scripts" / "requirements-test.txt").read_text().split())
    wanted = tomllib.loads((SDK / "pyproject.toml").read_text())["project"]["dependencies"]
    names = [re.split(r"[<>=]", dependency)[0] for dependency in wanted]
    return [f"{name}=={pins[name]}" for name in names]


def run(*command: str | Path, cwd: Path | None = None, env: dict[str, str] | None = None) -> str:
    done = subprocess.run(command, cwd=cwd, env=env, capture_output=True, text=True, timeout=180)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
