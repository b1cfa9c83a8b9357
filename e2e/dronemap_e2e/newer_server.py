"""An HTTP relay that makes a server look newer than it is: its answers have more than it describes."""

import http.client
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

# A drone is of a kind, and has a member beside it, that no description of today knows.
NEWER = (
    (b'"kind":"multicopter"', b'"wings":{"flap":[1]},"kind":"ornithopter"'),
    (b"<kind>multicopter</kind>", b"<wings><flap>1</flap></wings><kind>ornithopter</kind>"),
)


class NewerServer:
    """Relays to the server on that port until it is closed; counts the answers that it changed."""

    def __init__(self, port: int) -> None:
        self.changed = 0
        relay = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def _relayed(self) -> None:
                relay._relay(self, port)

            do_GET = do_POST = _relayed

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
        passed_on = ("accept", "authorization", "content-type", "soapaction")
        headers = {name: value for name, value in client.headers.items() if name.lower() in passed_on}
        server = http.client.HTTPConnection("127.0.0.1", port, timeout=100)
        server.request(client.command, client.path, body or None, headers)
        answer = server.getresponse()
        told = content = answer.read()
        server.close()
        for known, newer in NEWER:
            content = content.replace(known, newer)
        self.changed += content != told
        client.send_response(answer.status)
        client.send_header("Content-Type", answer.headers.get("Content-Type", ""))
        client.send_header("Content-Length", str(len(content)))
        client.end_headers()
        client.wfile.write(content)
