"""An HTTP relay before a server that records requests and answers of REST and SOAP."""

import http.client
import threading
from dataclasses import dataclass
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

# Of a request these make a difference to what is answered; of an answer, to who reads it.
REQUEST_HEADERS = ("Accept", "Authorization", "Content-Type", "Cookie", "SOAPAction", "X-Dronemap")
RESPONSE_HEADERS = ("Allow", "Location", "Retry-After", "Set-Cookie", "WWW-Authenticate")
# Pages, descriptions that the tree has in full, and records whose order is a matter of luck.
LEFT_OUT = ("?wsdl", "?WSDL", "?xsd", "/api/docs", "/api/openapi", "/api/v1/audit")


@dataclass(frozen=True)
class Exchange:
    """One request and its answer, as bytes that went over the line."""

    client: str
    method: str
    path: str
    request_headers: dict[str, str]
    body: str
    status: int
    content_type: str
    response_headers: dict[str, str]
    answer: str


class RecordingRelay:
    """A recording HTTP relay; `client` names the client of the next requests."""

    def __init__(self, port: int) -> None:
        self.client = "nobody"
        self.exchanges: list[Exchange] = []
        self._lock = threading.Lock()
        self._asked: set[tuple[str, str]] = set()
        relay = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def _relayed(self) -> None:
                relay._relay(self, port)

            do_GET = do_POST = do_PUT = do_PATCH = do_DELETE = _relayed

            def log_message(self, format: str, *arguments: object) -> None:
                pass

        self._server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._server.daemon_threads = True
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self._server.server_port}"

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()

    def _relay(self, client: BaseHTTPRequestHandler, port: int) -> None:
        body = client.rfile.read(int(client.headers.get("Content-Length") or 0))
        number = self._begin(client)
        # Compressed, an answer could not be read here.
        dropped = ("accept-encoding", "connection", "expect")
        headers = {name: value for name, value in client.headers.items() if name.lower() not in dropped}
        server = http.client.HTTPConnection("127.0.0.1", port, timeout=100)
        server.request(client.command, client.path, body or None, headers)
        answer = server.getresponse()
        content = answer.read()
        server.close()
        if number is not None:
            request_headers = {
                name: client.headers[name] for name in REQUEST_HEADERS if name in client.headers
            }
            response_headers = {
                name: answer.headers[name] for name in RESPONSE_HEADERS if name in answer.headers
            }
            self.exchanges[number] = Exchange(
                self.exchanges[number].client,
                client.command,
                client.path,
                request_headers,
                body.decode(),
                answer.status,
                answer.headers.get("Content-Type", ""),
                response_headers,
                content.decode(errors="replace"),
            )
        client.send_response(answer.status)
        for name, value in answer.headers.items():
            if name.lower() not in ("transfer-encoding", "content-length", "connection", "date"):
                client.send_header(name, value)
        client.send_header("Content-Length", str(len(content)))
        client.end_headers()
        client.wfile.write(content)

    def _begin(self, client: BaseHTTPRequestHandler) -> int | None:
        """Its place among all, by when it was asked; None: it is not kept."""
        path, method = client.path, client.command
        if not path.startswith(("/api/", "/services/")) or any(part in path for part in LEFT_OUT):
            return None
        with self._lock:
            if self.client == "page" and not self._is_new(method, path):
                return None
            self.exchanges.append(Exchange(self.client, method, path, {}, "", 0, "", {}, ""))
            return len(self.exchanges) - 1

    def _is_new(self, method: str, path: str) -> bool:
        """A page asks again and again: once between two things that a person does is enough."""
        # What rules and runs ordered meanwhile is among the orders of a drone, as luck has it.
        if (method, path) in self._asked or (method == "GET" and path.split("?")[0].endswith("/commands")):
            return False
        if method != "GET" and not path.endswith("/heartbeat"):
            self._asked = {asked for asked in self._asked if asked[0] != "GET"}
        else:
            self._asked.add((method, path))
        return True
