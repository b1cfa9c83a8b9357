"""Clients of other makers that call a server: curl, zeep and PHP's SoapClient."""

import json
import subprocess
from pathlib import Path
from typing import Any

import requests
import zeep
import zeep.exceptions

from .api import Json
from .waiting import wait_for
from .wire_relay import RecordingRelay

PASSWORD = "a long enough one"
NEXT_PASSWORD = "another long enough one"
NEAR = {"latitude": 47.3979, "longitude": 8.5456, "altitude": 20}
FAR = {"latitude": 47.3983, "longitude": 8.5462, "altitude": 20}
SQUARE = [[10.0, 60.0], [10.01, 60.0], [10.01, 60.01], [10.0, 60.01], [10.0, 60.0]]
PHP = Path(__file__).with_name("wire.php")


class Curl:
    """REST as a person tries it on a command line."""

    def __init__(self, relay: RecordingRelay, key: str) -> None:
        self._relay = relay
        self._key = key

    def __call__(
        self,
        method: str,
        path: str,
        body: object = None,
        *headers: str,
        key: str | None = "",
        kind: str = "application/json",
    ) -> Json:
        """`key`: another than its own; None: none."""
        self._relay.client = "curl"
        command = ["curl", "-sS", "-X", method, f"{self._relay.address}/api/v1{path}"]
        if key is not None:
            command += ["-H", f"Authorization: Bearer {key or self._key}"]
        for header in headers:
            command += ["-H", header]
        text = None
        if body is not None:
            text = body if isinstance(body, str) else json.dumps(body)
            command += ["-H", f"Content-Type: {kind}", "--data-binary", "@-"]
        done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=100)
        assert done.returncode == 0, done.stderr
        try:
            answer = json.loads(done.stdout)
        except ValueError:
            return {}
        return answer if isinstance(answer, dict) else {}

    def until(self, path: str, member: str, value: str) -> None:
        """Only the last look is kept: what came of it."""

        def looked() -> bool:
            before = len(self._relay.exchanges)
            seen = self("GET", path).get(member) == value
            if not seen:
                del self._relay.exchanges[before:]
            return seen

        wait_for(f"{path} is {value}", looked, 60)


def zeep_client(relay: RecordingRelay, key: str | None, version: str, service: str) -> Any:
    """`version`: of SOAP."""
    relay.client = f"zeep {version}"
    session = requests.Session()
    transport: Any = zeep.transports.Transport(session=session)  # type: ignore[no-untyped-call]
    client: Any = zeep.Client(  # type: ignore[no-untyped-call]
        f"{relay.address}/services/{service}?wsdl", transport=transport
    )
    if key:
        session.headers["Authorization"] = f"Bearer {key}"
    ports = client.wsdl.services[service].ports
    return client.bind(service, next(name for name in ports if name.endswith("12") == (version == "1.2")))


def call_operation(service: Any, operation: str, **arguments: object) -> Any:
    """Its answer; None where it is a fault, which is as good a thing to keep."""
    try:
        return getattr(service, operation)(**arguments)
    except (zeep.exceptions.Fault, zeep.exceptions.TransportError):
        return None


def run_php(relay: RecordingRelay, key: str, version: str, drone: str) -> None:
    relay.client = f"PHP {version}"
    done = subprocess.run(
        ["php", "-d", "soap.wsdl_cache_enabled=0", str(PHP), relay.address, key, version, drone],
        capture_output=True,
        text=True,
        timeout=100,
    )
    assert done.returncode == 0, done.stdout + done.stderr
