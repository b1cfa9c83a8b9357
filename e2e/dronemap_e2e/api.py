"""REST as a user's program would call it."""

from typing import Any

import requests

from . import seen_statuses
from .waiting import wait_for

Json = dict[str, Any]


class Api:
    """Calls with an access key, or, without, as a page does: with the cookie of its session."""

    def __init__(self, address: str, key: str | None = None, authority: str | None = None) -> None:
        """`authority`: the file of who signed the server's certificate."""
        self.base = address + "/api/v1"
        self.key = key
        self._session = requests.Session()
        self._session.hooks["response"].append(seen_statuses.note)
        if authority:
            self._session.verify = authority
            # Whom the environment trusts would go before.
            self._session.trust_env = False
        if key:
            self._session.headers["Authorization"] = f"Bearer {key}"
        else:
            self._session.headers["X-Dronemap"] = "1"

    def get(self, path: str) -> Json:
        answer = self.call("GET", path)
        assert answer.ok, answer.text
        body: Json = answer.json()
        return body

    def call(self, method: str, path: str, body: Json | None = None) -> requests.Response:
        return self._session.request(method, self.base + path, json=body, timeout=70)

    def post_bytes(self, path: str, data: bytes) -> requests.Response:
        return self._session.post(
            self.base + path, data=data, headers={"Content-Type": "application/octet-stream"}, timeout=120
        )

    def post_text(self, path: str, text: str) -> requests.Response:
        return self._session.post(
            self.base + path, data=text.encode(), headers={"Content-Type": "text/plain"}, timeout=70
        )

    def text(self, path: str) -> str:
        answer = self.call("GET", path)
        assert answer.ok, answer.text
        return answer.text

    def content(self, path: str) -> bytes:
        answer = self.call("GET", path)
        assert answer.ok, answer.text
        return answer.content

    def ended(self, command: str, seconds: float) -> Json:
        """The command's record once it has its outcome."""

        def look() -> Json | None:
            record = self.get(f"/commands/{command}")
            return record if record["outcome"] else None

        return wait_for(f"command {command} has ended", look, seconds)

    def drones(self) -> list[Json]:
        drones: list[Json] = self.get("/drones")["drones"]
        return drones

    def drone(self, drone: str) -> Json:
        return self.get(f"/drones/{drone}")

    def ready(self, system_id: int) -> Json | None:
        """The live drone with that system id, once it has a home and says that it may be armed."""
        return next(
            (
                d
                for d in self.drones()
                if d["link"]["systemId"] == system_id
                and d["link"]["state"] == "live"
                and d["position"]
                and d["home"]
                and d["readyToArm"] is not False
                and (d["readyToArm"] or d["autopilot"] == "PX4")
            ),
            None,
        )

    def command(self, drone: str, body: Json, wait: int = 60) -> Json:
        """The command's record once it has ended."""
        answer = self.call("POST", f"/drones/{drone}/commands?wait={wait}", body)
        refused = answer.status_code == 409 and answer.json().get("commandId")
        assert answer.ok or refused, answer.text
        record: Json = self.get(f"/commands/{answer.json()['commandId']}") if refused else answer.json()
        return record

    def do(self, drone: str, **body: Any) -> Json:
        """Commands and insists on success."""
        record = self.command(drone, body)
        assert record["outcome"] and record["outcome"]["result"] == "succeeded", record
        return record

    def new_key(self, label: str, role: str) -> str:
        answer = self.call("POST", "/access-keys", {"label": label, "role": role})
        assert answer.status_code == 201, answer.text
        key: str = answer.json()["key"]
        return key
