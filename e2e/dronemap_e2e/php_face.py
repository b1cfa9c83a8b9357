"""Commands by the PHP SOAP proxy, as a program asks it: AJAX's JSON over PHP's SOAP client."""

import secrets
from pathlib import Path
from typing import Any

import requests

from .api import Json
from .faces import Said, outcome
from .php_proxy import PhpProxy
from .server import Server


class PhpSession:
    """A browser that is signed in at the proxy."""

    def __init__(self, proxy: PhpProxy, proof: dict[str, str]) -> None:
        self._proxy = proxy
        self.browser = requests.Session()
        answer = self.browser.post(f"{proxy.address}/session.php", json=proof, timeout=30)
        assert answer.ok, answer.text
        self.browser.headers["X-Dronemap-Token"] = answer.json()["token"]

    def call(self, operation: str, arguments: Json, timeout: float = 90) -> requests.Response:
        address = f"{self._proxy.address}/proxy.php?operation={operation}"
        return self.browser.post(address, json=arguments, timeout=timeout)


class PhpFace:
    """SOAP by the PHP proxy."""

    NAMES = {"takeOff": "takeoff", "goTo": "goto"}

    def __init__(self, server: Server, key: str, folder: Path) -> None:
        self._proxy = PhpProxy(server.address, folder)
        self._proxy.start()
        self._session = PhpSession(self._proxy, {"key": key})

    def drones(self) -> list[str]:
        return [drone["id"] for drone in self._session.call("getDronesList", {}).json()["drones"]]

    def control(self, drone: str, operation: str) -> Json:
        told: Json = self._session.call(operation, {"droneId": drone}).json()
        return told

    def command(self, drone: str, body: Json) -> Said:
        members = {name: _steps(value) for name, value in body.items() if name != "type"}
        kind = str(body["type"])
        own = {"droneId": drone, "id": secrets.token_urlsafe(12), "wait": 60}
        answer = self._session.call(self.NAMES.get(kind, kind), own | members)
        told = answer.json()
        if answer.ok:
            return outcome(told["outcome"])
        return (None, None, told["code"], told["detail"], told.get("field"))

    def close(self) -> None:
        self._proxy.stop()


def _steps(value: Any) -> Any:
    """Steps of a mission by the element of their type."""
    if not isinstance(value, list):
        return value
    return [{step["type"]: {name: part for name, part in step.items() if name != "type"}} for step in value]
