"""A server of this machine has another key after each start, and clients go on."""

import asyncio
from pathlib import Path

import httpx
import pytest

from dronemap import Server
from dronemap.transport import BASE, HttpTransport

OLD, NEW = "old-key", "new-key"


def transport_of(file: Path, key_that_counts: str, at_once: int = 1) -> HttpTransport:
    """Whoever shows another key is refused once all have asked."""
    all_asked = asyncio.Barrier(at_once)

    async def answer(request: httpx.Request) -> httpx.Response:
        if request.headers["Authorization"] == f"Bearer {key_that_counts}":
            return httpx.Response(200, json={})
        await all_asked.wait()
        return httpx.Response(401, json={})

    made = HttpTransport(Server("http://127.0.0.1:1", OLD, key_file=file))
    made._http = httpx.AsyncClient(base_url=f"http://127.0.0.1:1{BASE}", transport=httpx.MockTransport(answer))
    return made


@pytest.mark.parametrize("at_once", [1, 5])
def test_requests_go_on_with_the_newer_key_of_the_file(tmp_path: Path, at_once: int) -> None:
    file = tmp_path / "local-key"
    file.write_text(f"{NEW}\n")

    async def statuses() -> list[int]:
        made = transport_of(file, NEW, at_once)
        answers = await asyncio.gather(*(made.request("GET", "/drones", query={}) for _ in range(at_once)))
        return [answer.status for answer in answers]

    assert asyncio.run(statuses()) == [200] * at_once


def test_key_that_counts_no_more_is_told(tmp_path: Path) -> None:
    file = tmp_path / "local-key"
    file.write_text(OLD)

    async def status() -> int:
        return (await transport_of(file, NEW).request("GET", "/drones", query={})).status

    assert asyncio.run(status()) == 401
