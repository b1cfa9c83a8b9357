"""Questions of tests to a server that runs, and to the machine about it."""

import json
import re
import ssl
import subprocess
import urllib.request
from pathlib import Path
from typing import Any

from .conftest import Checkout

NEW_PASSWORD = 'a "new" \\ pass phrase'


def listeners(pids: set[int]) -> list[str]:
    """Local addresses on which processes listen or receive."""
    lines = subprocess.run(["ss", "-Hltnup"], text=True, capture_output=True, check=True).stdout.splitlines()
    return [line.split()[4] for line in lines if pids & {int(pid) for pid in re.findall(r"pid=(\d+)", line)}]


def descendants(data: Path) -> set[int]:
    """The server, the demo fleet and everything that they started, by the data folder that they work in."""
    found = set()
    for process in Path("/proc").glob("[0-9]*"):
        try:
            in_data = (process / "cwd").readlink().is_relative_to(data)
        except OSError:
            continue
        if in_data:
            found.add(int(process.name))
    return found


def get(url: str) -> tuple[int, str]:
    own_certificate = ssl.create_default_context()
    own_certificate.check_hostname = False
    own_certificate.verify_mode = ssl.CERT_NONE
    with urllib.request.urlopen(url, timeout=5, context=own_certificate) as answer:
        return answer.status, answer.read().decode()


def pid_of(checkout: Checkout, name: str) -> int:
    return int((checkout.data / f"{name}.pid").read_text())


def call_rest(built: Checkout, path: str, body: dict[str, Any] | None = None) -> str:
    """An answer of REST to this machine's own key; with a body it is a POST."""
    key = (built.data / "local-key").read_text().strip()
    request = urllib.request.Request(
        f"http://127.0.0.1:{built.http_port}/api/v1{path}",
        data=None if body is None else json.dumps(body).encode(),
        headers={"Authorization": f"Bearer {key}", "Content-Type": "application/json"},
    )
    with urllib.request.urlopen(request, timeout=30) as answer:
        text: str = answer.read().decode()
    return text
