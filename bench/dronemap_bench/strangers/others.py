"""Clients that are not part of the attack: viewers of the stream, vehicles on a WebSocket, REST callers.

`python -m dronemap_bench.strangers.others viewers|vehicles|calls …`: says "ready", measures until its input
ends, and prints its samples as JSON: [when, milliseconds], by the machine's clock, from when each was due.
"""

import argparse
import http.client
import json
import re
import selectors
import sys
import threading
import time

from . import mavlink, wire

VEHICLES, RATE = 10, 10
VIEWERS = 10
CALLERS, CALLS_PER_SECOND = 4, 10
# What the server gives its vehicles.
HEARTBEAT_SECONDS = 0.5
PATHS = ("/api/v1/drones", "/api/v1/missions", "/api/v1/health")
PLACE = re.compile(rb'"position":\{.*?"latitude":([-+.\dE]+).*?"longitude":([-+.\dE]+)')

Sample = tuple[float, float]


class InputEnd:
    """Set when the input ends."""

    def __init__(self) -> None:
        self._event = threading.Event()
        threading.Thread(target=self._wait, daemon=True).start()

    def _wait(self) -> None:
        sys.stdin.read()
        self._event.set()

    def __bool__(self) -> bool:
        return self._event.is_set()


def due(start: float, vehicle: int, step: int) -> float:
    return start + step / RATE + vehicle / (VEHICLES * RATE)


def viewers(port: int, start: float, key: str, over: InputEnd) -> list[Sample]:
    """Measures the age of each new position on arrival, from when the vehicle was due to send it."""
    waiting = selectors.DefaultSelector()
    for _ in range(VIEWERS):
        line = wire.connect(port, "/stream", f"Authorization: Bearer {key}")
        waiting.register(line, selectors.EVENT_READ, (wire.Reader(line), [-1] * VEHICLES))
    print("ready", flush=True)
    samples: list[Sample] = []
    while not over:
        for key_of, _ in waiting.select(0.2):
            reader, newest = key_of.data
            for text in reader.frames():
                now = time.monotonic()
                if (place := _place(text)) and place[1] > newest[place[0]]:
                    vehicle, step = place
                    newest[vehicle] = step
                    samples.append((now, 1_000 * (now - due(start, vehicle, step))))
    return samples


def _place(text: bytes) -> tuple[int, int] | None:
    if not text.startswith(b'{"type":"drone"'):
        return None
    found = PLACE.search(text)
    if found is None:
        return None
    step = round(float(found[1]) * 1e7) - mavlink.LATITUDE_E7
    vehicle = (round(float(found[2]) * 1e7) - mavlink.LONGITUDE_E7) // mavlink.VEHICLE_E7
    return (vehicle, step) if 0 <= vehicle < VEHICLES else None


def vehicles(port: int, start: float, over: InputEnd) -> list[Sample]:
    """Measures how late each heartbeat of the server comes after the last one."""
    waiting = selectors.DefaultSelector()
    lines = [wire.connect(port, "/") for _ in range(VEHICLES)]
    for vehicle, line in enumerate(lines):
        waiting.register(line, selectors.EVENT_READ, (vehicle, wire.Reader(line)))
    print("ready", flush=True)
    samples: list[Sample] = []
    last: list[float | None] = [None] * VEHICLES
    turn = 0
    while not over:
        step, vehicle = divmod(turn, VEHICLES)
        when = due(start, vehicle, step)
        if (left := when - time.monotonic()) <= 0:
            message = (
                mavlink.heartbeat(step, vehicle + 1)
                if step % RATE == 0
                else mavlink.position(step, vehicle, step, vehicle + 1)
            )
            lines[vehicle].sendall(wire.frame(wire.BINARY, message))
            turn += 1
            left = 0
        for key_of, _ in waiting.select(left):
            of, reader = key_of.data
            for received in reader.frames():
                if mavlink.has_heartbeat(received):
                    now = time.monotonic()
                    before = last[of]
                    if before is not None:
                        samples.append((now, max(0.0, 1_000 * (now - before - HEARTBEAT_SECONDS))))
                    last[of] = now
    return samples


def calls(port: int, start: float, key: str, over: InputEnd) -> list[Sample]:
    """Measures how long after it was due each call was answered."""
    samples: list[Sample] = []
    failures: list[str] = []

    def call(caller: int) -> None:
        connection = http.client.HTTPConnection(wire.LOOPBACK, port, timeout=30)
        number = 0
        while not over and not failures:
            when = start + (number * CALLERS + caller) / (CALLERS * CALLS_PER_SECOND)
            time.sleep(max(0.0, when - time.monotonic()))
            path = PATHS[number % len(PATHS)]
            connection.request("GET", path, headers={"Authorization": f"Bearer {key}"})
            answer = connection.getresponse()
            answer.read()
            if answer.status != 200:
                failures.append(f"{path} was answered by {answer.status}")
            now = time.monotonic()
            samples.append((now, 1_000 * (now - when)))
            number += 1

    threads = [threading.Thread(target=call, args=(caller,)) for caller in range(CALLERS)]
    print("ready", flush=True)
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if failures:
        raise SystemExit(failures[0])
    return samples


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="python -m dronemap_bench.strangers.others", description=__doc__)
    parser.add_argument("who", choices=("viewers", "vehicles", "calls"))
    parser.add_argument("--port", type=int, required=True)
    parser.add_argument("--start", type=float, required=True, help="of the machine's own clock")
    parser.add_argument("--key", default="")
    options = parser.parse_args(arguments)
    over = InputEnd()
    if options.who == "viewers":
        samples = viewers(options.port, options.start, options.key, over)
    elif options.who == "vehicles":
        samples = vehicles(options.port, options.start, over)
    else:
        samples = calls(options.port, options.start, options.key, over)
    print(json.dumps({"samples": samples}), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
