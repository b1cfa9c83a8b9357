"""`bench/php`: how much longer a call takes by the PHP SOAP proxy than by SOAP itself; a table and JSON."""

import argparse
import http.client
import json
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from .__main__ import about
from .programs import LOAD_JAR, ROOT, Json, Server, free_port

GOAL_MILLISECONDS = 5.0
ENVELOPE = """<s:Envelope xmlns:s="http://schemas.xmlsoap.org/soap/envelope/"><s:Body>
<{0} xmlns="http://cloud.dronemap.org/wsdl">{1}</{0}></s:Body></s:Envelope>"""


@dataclass(frozen=True)
class Options:
    """Calls of a round by each way, and drones that are listed."""

    rounds: int = 5
    calls: int = 400
    drones: int = 4


class Soap:
    """SOAP by hand: what a call takes without PHP. Each has a connection of its own, as PHP's have."""

    def __init__(self, server: Server) -> None:
        self._port = server.http_port
        self._key = server.key()

    def call(self, operation: str, drone: str | None) -> None:
        children = "" if drone is None else f'<droneId xmlns="">{drone}</droneId>'
        headers = {"Authorization": f"Bearer {self._key}", "Content-Type": "text/xml; charset=utf-8"}
        body = ENVELOPE.format(operation, children)
        path = "/services/MAVLinkControllerService"
        answer = ask(self._port, "POST", path, body, headers)
        assert b"Response" in answer, answer


class Proxy:
    """The same by the proxy, signed in."""

    def __init__(self, port: int, key: str) -> None:
        self._port = port
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
        connection.request(
            "POST", "/session.php", json.dumps({"key": key}), {"Content-Type": "application/json"}
        )
        answer = connection.getresponse()
        session = json.loads(answer.read())
        assert answer.status == 200, session
        self._headers = {
            "X-Dronemap-Token": session["token"],
            "Cookie": str(answer.getheader("Set-Cookie")).partition(";")[0],
        }

    def call(self, operation: str, drone: str | None) -> None:
        wanted = "" if drone is None else f"&droneId={drone}"
        answer = ask(self._port, "GET", f"/proxy.php?operation={operation}{wanted}", None, self._headers)
        assert json.loads(answer)


def ask(port: int, method: str, path: str, body: str | None, headers: dict[str, str]) -> bytes:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    try:
        connection.request(method, path, body, headers)
        answer = connection.getresponse()
        content = answer.read()
        assert answer.status == 200, content
        return content
    finally:
        connection.close()


def measure(options: Options) -> list[Json]:
    """Each round: p50 and p95 in milliseconds by either way, of one drone and of the list of all."""
    with tempfile.TemporaryDirectory() as folder:
        # One program asks more often than one user may.
        server = Server(Path(folder) / "data", settings={"DRONEMAP_RATE_REQUESTS": "0"})
        fleet = _fleet(server, options.drones)
        try:
            with _php(server, Path(folder)) as port:
                soap, proxy = Soap(server), Proxy(port, server.key())
                drone = _drone(server, options.drones)
                wanted = {"one drone": ("getDrone", drone), "list": ("getDronesList", None)}
                made = []
                for number in range(options.rounds + 1):
                    print(f"[{number}/{options.rounds}]", file=sys.stderr)
                    figures = {
                        name: _in_turn(options.calls, soap.call, proxy.call, *what)
                        for name, what in wanted.items()
                    }
                    made.append(figures)
                # The first one warms both up: each process of PHP reads the description once.
                return made[1:]
        finally:
            fleet.terminate()
            fleet.wait()
            server.stop()


def _in_turn(
    calls: int,
    soap: Callable[[str, str | None], None],
    proxy: Callable[[str, str | None], None],
    operation: str,
    drone: str | None,
) -> Json:
    took: dict[str, list[float]] = {"soap": [], "proxy": []}
    for _ in range(calls):
        for name, call in (("soap", soap), ("proxy", proxy)):
            begun = time.perf_counter()
            call(operation, drone)
            took[name].append(1000 * (time.perf_counter() - begun))
    figures: Json = {
        name: {"p50": statistics.median(each), "p95": statistics.quantiles(each, n=20)[-1]}
        for name, each in took.items()
    }
    figures["added"] = {part: figures["proxy"][part] - figures["soap"][part] for part in ("p50", "p95")}
    return figures


def _fleet(server: Server, count: int) -> "subprocess.Popen[bytes]":
    address = f"udp://127.0.0.1:{server.udp_port}"
    return subprocess.Popen(
        ["java", "-jar", str(LOAD_JAR), "--connect", address, "--count", str(count), "--sysid", "1"],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def _drone(server: Server, count: int) -> str:
    """One of them, once all are there."""
    headers = {"Authorization": f"Bearer {server.key()}"}
    for _ in range(600):
        drones = json.loads(ask(server.http_port, "GET", "/api/v1/drones", None, headers))["drones"]
        if len(drones) == count:
            return str(drones[0]["id"])
        time.sleep(0.1)
    raise SystemExit("The drones did not come.")


@contextmanager
def _php(server: Server, folder: Path) -> Iterator[int]:
    port = free_port()
    named = {
        "DRONEMAP_PHP_SERVER": f"http://127.0.0.1:{server.http_port}",
        "DRONEMAP_PHP_SESSIONS": str(folder / "sessions"),
        "PHP_CLI_SERVER_WORKERS": "4",
    }
    public = ROOT / "php-soap-proxy" / "public"
    process = subprocess.Popen(
        ["php", "-q", "-d", "opcache.enable_cli=1", "-S", f"127.0.0.1:{port}", "-t", str(public)],
        env=os.environ | named,
        start_new_session=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        for _ in range(100):
            try:
                ask(port, "GET", "/", None, {})
                break
            except ConnectionError:
                time.sleep(0.1)
        yield port
    finally:
        os.killpg(process.pid, signal.SIGTERM)
        process.wait()


def summary(rounds: list[Json]) -> Json:
    """Median and worst round of each figure."""
    return {
        name: {
            way: {
                part: {"median": statistics.median(values), "worst": max(values)}
                for part in ("p50", "p95")
                for values in [[each[name][way][part] for each in rounds]]
            }
            for way in ("soap", "proxy", "added")
        }
        for name in rounds[0]
    }


def table(figures: Json, options: Options, load: float) -> str:
    lines = [
        f"{options.drones} drones, {about()['processor']}, load {load:.1f} before it began; ms.",
        "",
        "| call | SOAP p50 | p95 | by the proxy p50 | p95 | added p50 | added p95, median | worst |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    for name, ways in figures.items():
        medians = [ways[way][part]["median"] for way in ("soap", "proxy") for part in ("p50", "p95")]
        medians += [ways["added"]["p50"]["median"], ways["added"]["p95"]["median"]]
        row = " | ".join(f"{figure:.2f}" for figure in [*medians, ways["added"]["p95"]["worst"]])
        lines.append(f"| {name} | {row} |")
    return "\n".join(lines)


def missed(figures: Json) -> bool:
    return any(ways["added"]["p95"]["median"] > GOAL_MILLISECONDS for ways in figures.values())


def main(arguments: list[str]) -> int:
    usual = Options()
    parser = argparse.ArgumentParser(prog="bench/php", description=__doc__)
    parser.add_argument("--rounds", type=int, default=usual.rounds)
    parser.add_argument("--calls", type=int, default=usual.calls)
    parser.add_argument("--drones", type=int, default=usual.drones)
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results" / "php.json")
    chosen = parser.parse_args(arguments)
    options = Options(chosen.rounds, chosen.calls, chosen.drones)
    load = os.getloadavg()[0]
    rounds = measure(options)
    figures = summary(rounds)
    chosen.out.parent.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about(), "loadBefore": load, "summary": figures, "rounds": rounds}
    chosen.out.write_text(json.dumps(whole, indent=1) + "\n")
    print(table(figures, options, load))
    if missed(figures):
        print(f"Missed: {GOAL_MILLISECONDS:.0f} ms added at p95.")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
