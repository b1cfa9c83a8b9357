"""Users with a signing passphrase, for ground stations at the outlet."""

import http.cookiejar
import json
import secrets
import urllib.request
from typing import Any

from .programs import Server

CLIENTS_OF_A_USER = 20


class Session:
    """Signed in as a user, or by the server's local key."""

    def __init__(self, server: Server, key: str | None = None) -> None:
        self._address = f"http://127.0.0.1:{server.http_port}/api/v1"
        self._headers = {"Content-Type": "application/json", "X-Dronemap": "1"}
        if key:
            self._headers["Authorization"] = f"Bearer {key}"
        cookies = urllib.request.HTTPCookieProcessor(http.cookiejar.CookieJar())
        self._opener = urllib.request.build_opener(cookies)

    def call(self, method: str, path: str, body: dict[str, Any]) -> dict[str, Any]:
        request = urllib.request.Request(
            self._address + path, json.dumps(body).encode(), self._headers, method=method
        )
        with self._opener.open(request, timeout=60) as answer:
            text = answer.read()
        found: dict[str, Any] = json.loads(text) if text else {}
        return found


def passphrases(server: Server, clients: int) -> list[str]:
    """Passphrases of as many new viewers as so many clients need."""
    root = Session(server, server.key())
    made = []
    for _ in range(-(-clients // CLIENTS_OF_A_USER)):
        name, first, own = f"viewer-{secrets.token_hex(4)}", secrets.token_hex(10), secrets.token_hex(10)
        root.call("POST", "/users", {"name": name, "password": first, "role": "viewer"})
        session = Session(server)
        session.call("POST", "/session", {"name": name, "password": first})
        session.call("POST", "/session/password", {"current": first, "next": own})
        made.append(str(session.call("PUT", "/outlet/passphrase", {})["passphrase"]))
    return made
