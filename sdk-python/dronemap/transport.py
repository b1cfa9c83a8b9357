"""How requests and the stream travel: over HTTP and a WebSocket, or whatever a test puts in their place."""

import functools
import ssl
from collections.abc import Mapping
from contextlib import AbstractAsyncContextManager
from dataclasses import dataclass
from typing import Protocol
from urllib.parse import urlsplit

import httpx
import websockets
from websockets.asyncio.client import connect

from dronemap.connection import Server, read_key
from dronemap.errors import AnswerLost, Unreachable

BASE = "/api/v1"
#: Seconds; a command may wait for its outcome for a minute.
_READ_SECONDS = 75.0
_CONNECT_SECONDS = 5.0
_NOT_SIGNED_IN = 401
#: A fleet's first list may be long.
_LARGEST_MESSAGE = 64 * 1024 * 1024


@dataclass(frozen=True)
class HttpAnswer:
    """An answer of REST as it came; names of headers in lower case."""

    status: int
    headers: Mapping[str, str]
    content: bytes


class StreamSocket(Protocol):
    """An open stream; both ends with `StreamClosed` when it is over."""

    async def receive(self) -> str | bytes: ...

    async def send(self, text: str) -> None: ...


class StreamClosed(Exception):
    """The stream was closed, or its connection was cut."""


class Transport(Protocol):
    """Whatever brings a request to a server, and opens its stream."""

    async def request(
        self,
        method: str,
        path: str,
        *,
        query: Mapping[str, str],
        content: bytes | None = None,
        content_type: str | None = None,
    ) -> HttpAnswer:
        """Raises `Unreachable` when it was not sent, `AnswerLost` when it may have been."""

    def stream(self, port: int) -> AbstractAsyncContextManager[StreamSocket]: ...

    async def close(self) -> None: ...


class HttpTransport:
    """Requests over HTTP and the stream over a WebSocket, signed in by an access key."""

    def __init__(self, server: Server) -> None:
        self._server = server
        self._key = server.key
        self._trust: ssl.SSLContext | None = None
        if urlsplit(server.url).scheme == "https":
            self._trust = ssl.create_default_context(cafile=server.certificate)
        self._http = httpx.AsyncClient(
            base_url=server.url + BASE,
            # A browser's session has to send X-Dronemap; nobody else minds.
            headers={"X-Dronemap": "1"},
            timeout=httpx.Timeout(_READ_SECONDS, connect=_CONNECT_SECONDS),
            verify=self._trust or True,
            trust_env=False,
        )

    async def request(
        self,
        method: str,
        path: str,
        *,
        query: Mapping[str, str],
        content: bytes | None = None,
        content_type: str | None = None,
    ) -> HttpAnswer:
        headers = {"Content-Type": content_type} if content is not None and content_type else {}
        ask = functools.partial(self._http.request, method, path, params=dict(query), content=content)
        shown = self._key
        try:
            answer = await ask(headers=headers | self._signed())
            if answer.status_code == _NOT_SIGNED_IN and self._has_newer_key(shown):
                answer = await ask(headers=headers | self._signed())
        except (httpx.ConnectError, httpx.ConnectTimeout, httpx.PoolTimeout) as e:
            raise Unreachable(f"{self._server.url} cannot be reached: {e or type(e).__name__}") from e
        except httpx.TransportError as e:
            raise AnswerLost(
                f"The connection to {self._server.url} ended before the answer came; "
                "whether the request was carried out is not known."
            ) from e
        return HttpAnswer(answer.status_code, answer.headers, answer.content)

    def stream(self, port: int) -> AbstractAsyncContextManager[StreamSocket]:
        return _WebSocket(self._stream_address(port), self._signed(), self._trust)

    def _signed(self) -> dict[str, str]:
        return {"Authorization": f"Bearer {self._key}"} if self._key else {}

    def _has_newer_key(self, shown: str | None) -> bool:
        """Than the one that was shown: another request may have found it meanwhile."""
        file = self._server.key_file
        if file is not None and file.exists():
            self._key = read_key(file)
        return self._key != shown

    def _stream_address(self, port: int) -> str:
        parts = urlsplit(self._server.url)
        scheme = "wss" if parts.scheme == "https" else "ws"
        host = f"[{parts.hostname}]" if ":" in (parts.hostname or "") else parts.hostname
        return f"{scheme}://{host}:{port}/stream"

    async def close(self) -> None:
        await self._http.aclose()


class _WebSocket(AbstractAsyncContextManager[StreamSocket]):
    def __init__(self, address: str, headers: Mapping[str, str], trust: ssl.SSLContext | None) -> None:
        self._connecting = connect(
            address,
            additional_headers=headers,
            ssl=trust,
            max_size=_LARGEST_MESSAGE,
            open_timeout=_CONNECT_SECONDS,
            # The server says something each second, and whoever hears nothing connects anew.
            ping_interval=None,
            close_timeout=1,
            compression=None,
            proxy=None,
        )

    async def __aenter__(self) -> StreamSocket:
        try:
            self._socket = await self._connecting
        except (OSError, TimeoutError, websockets.WebSocketException) as e:
            raise StreamClosed(str(e)) from e
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._socket.close()

    async def receive(self) -> str | bytes:
        try:
            return await self._socket.recv(decode=False)
        except websockets.ConnectionClosed as e:
            raise StreamClosed(str(e)) from e

    async def send(self, text: str) -> None:
        try:
            await self._socket.send(text)
        except websockets.ConnectionClosed as e:
            raise StreamClosed(str(e)) from e
