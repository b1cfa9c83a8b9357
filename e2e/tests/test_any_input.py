"""Sends unexpected input to REST, generated from its description by another maker's program."""

import secrets
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server

SECONDS_PER_ROLE = 100
CHECKS = "not_a_server_error,status_code_conformance,content_type_conformance,response_schema_conformance"
# They end what the program itself came in by.
LEFT_OUT = ("signIn", "signOut", "signOutEverywhere")


def key_of(api: Api, role: str) -> str:
    name = f"{role}-{secrets.token_hex(4)}"
    made = api.call("POST", "/users", {"name": name, "password": secrets.token_hex(10), "role": role})
    assert made.status_code == 201, made.text
    key = api.call("POST", "/access-keys", {"label": name, "role": role})
    assert key.status_code == 201, key.text
    return str(key.json()["key"])


@pytest.mark.soak
@pytest.mark.parametrize("role", ["viewer", "operator", "administrator"])
def test_every_answer_matches_the_rest_description(
    role: str, server: Server, api: Api, copter: Json, tmp_path: Path
) -> None:
    """End to end because a program of another maker reads the description and calls the server."""
    program = shutil.which("schemathesis", path=str(Path(sys.executable).parent))
    assert program, "schemathesis is missing: ./dronemap test installs it"
    left_out = [word for operation in LEFT_OUT for word in ("--exclude-operation-id", operation)]
    done = subprocess.run(
        [program, "run", f"{server.address}/api/openapi.json", *left_out]
        + ["-H", f"Authorization: Bearer {key_of(api, role)}", "-c", CHECKS]
        + ["--max-time", str(SECONDS_PER_ROLE), "--continue-on-failure", "--warnings", "off", "--no-color"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=SECONDS_PER_ROLE * 3,
    )
    assert done.returncode == 0, done.stdout[-6000:] + done.stderr[-2000:]
    assert api.call("GET", f"/drones/{copter['id']}").status_code == 200
    log = (server.data / "server.log").read_text()
    assert " ERROR " not in log, [line for line in log.splitlines() if " ERROR " in line][:5]
