"""Calls one after the other on one connection for each face, as programs make them."""

import http.client
import json
import time
from collections.abc import Callable
from xml.sax.saxutils import escape

from ..programs import Json, Server

SECONDS = 60
CONTROLLER = "/services/MAVLinkControllerService"


class ApiCaller:
    """Calls one server by REST and SOAP, with the server's local key."""

    def __init__(self, server: Server) -> None:
        self._rest = http.client.HTTPConnection("127.0.0.1", server.http_port, timeout=SECONDS)
        self._soap = http.client.HTTPConnection("127.0.0.1", server.http_port, timeout=SECONDS)
        self._headers = {"Authorization": f"Bearer {server.key()}"}

    def rest(self, path: str, body: Json | None = None) -> bytes:
        method = "GET" if body is None else "POST"
        headers = self._headers | ({} if body is None else {"Content-Type": "application/json"})
        data = None if body is None else json.dumps(body)
        return self._answer(self._rest, method, f"/api/v1{path}", data, headers)

    def soap(self, operation: str, **values: object) -> bytes:
        inside = "".join(f"<{name}>{escape(str(value))}</{name}>" for name, value in values.items())
        body = (
            '<s:Envelope xmlns:s="http://schemas.xmlsoap.org/soap/envelope/"><s:Body>'
            f'<d:{operation} xmlns:d="http://cloud.dronemap.org/wsdl">{inside}</d:{operation}>'
            "</s:Body></s:Envelope>"
        )
        headers = self._headers | {"Content-Type": "text/xml; charset=utf-8", "SOAPAction": '""'}
        return self._answer(self._soap, "POST", CONTROLLER, body, headers)

    @staticmethod
    def _answer(
        line: http.client.HTTPConnection, method: str, path: str, body: str | None, headers: dict[str, str]
    ) -> bytes:
        line.request(method, path, body, headers)
        answer = line.getresponse()
        data = answer.read()
        if answer.status != 200:
            raise SystemExit(f"{method} {path} was answered by {answer.status}: {data[:500]!r}")
        return data

    def close(self) -> None:
        self._rest.close()
        self._soap.close()


def time_interleaved(count: int, *calls: Callable[[], object]) -> list[list[float]]:
    """Milliseconds of each of these calls, which are made in turn so that all meet the same machine."""
    took: list[list[float]] = [[] for _ in calls]
    for _ in range(count):
        for call, times in zip(calls, took, strict=True):
            start = time.perf_counter()
            call()
            times.append(1_000 * (time.perf_counter() - start))
    return took


def percentile(values: list[float], share: float) -> float:
    """The least value that this share of all does not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]
