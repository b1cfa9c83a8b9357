#!/usr/bin/env python3
"""Record the fixed list of exchanges with a real ArduPilot vehicle as JSON lines, one file an exchange.

With --sitl the program starts a fresh software-in-the-loop vehicle for each exchange, several at a time, in real time.
--vehicle says which one it is. With --connect it records one exchange (--only NAME) with a vehicle that is already
there, such as udpin:127.0.0.1:15700.
"""

from __future__ import annotations

import argparse
import contextlib
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from exchange import Exchange
from transcript import Transcript
from vehicle_link import VehicleLink
from vehicles import VEHICLES, Vehicle

HOME = "-35.363261,149.165230,584,353"
RECORDED = Path(__file__).parent / "recorded"


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    peer = parser.add_mutually_exclusive_group(required=True)
    peer.add_argument("--sitl", type=Path, metavar="PATH", help="the vehicle's binary, such as arducopter")
    peer.add_argument("--connect", metavar="ADDRESS", help="a pymavlink address; needs --only")
    parser.add_argument("--vehicle", choices=VEHICLES, default="copter", help="which one it is (default copter)")
    parser.add_argument(
        "--defaults", type=Path, help="parameter defaults (default: copter.parm and the like beside it)"
    )
    parser.add_argument("--only", action="append", metavar="NAME", help="record this exchange (may be repeated)")
    parser.add_argument("--jobs", type=int, default=8, help="vehicles at the same time (default 8)")
    parser.add_argument(
        "--first-port", type=int, default=15700, help="two UDP ports a job from here on (default 15700)"
    )
    parser.add_argument("--out", type=Path, default=RECORDED, help="folder of the files (default: recorded/)")
    parser.add_argument("--list", action="store_true", help="say which exchanges there are, record nothing")
    return parser.parse_args()


def chosen(vehicle: Vehicle, names: list[str] | None) -> list[Exchange]:
    """The exchanges asked for, all of the vehicle by default."""
    if not names:
        return list(vehicle.exchanges)
    by_name = {exchange.name: exchange for exchange in vehicle.exchanges}
    unknown = sorted(set(names) - by_name.keys())
    if unknown:
        sys.exit(f"no exchange is called {', '.join(unknown)}; there are {', '.join(by_name)}")
    return [by_name[name] for name in names]


@contextlib.contextmanager
def running(
    options: argparse.Namespace, port: int, folder: str, boot_parameters: Mapping[str, float] | None = None
) -> Iterator[None]:
    """A software-in-the-loop vehicle that talks to `port` on this machine, until the block ends."""
    vehicle = VEHICLES[options.vehicle]
    defaults = options.defaults or options.sitl.parent / vehicle.defaults
    if boot_parameters:
        lines = "".join(f"\n{name} {value}" for name, value in boot_parameters.items())
        own = Path(folder) / "defaults.parm"
        own.write_text(defaults.read_text(encoding="utf-8") + lines + "\n", encoding="utf-8")
        defaults = own
    command = [
        str(options.sitl.resolve()), "--wipe", "--model", vehicle.model, "--speedup", "1",
        "--defaults", str(defaults.resolve()), "--home", HOME, "--rc-in-port", str(port + 1),
        "--serial0", f"udpclient:127.0.0.1:{port}", "--serial1", "none", "--serial2", "none",
    ]  # fmt: skip
    log_path = Path(folder) / "vehicle.log"
    with log_path.open("w", encoding="utf-8") as log:
        process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=log)
    try:
        yield
    finally:
        process.terminate()
        process.wait(timeout=10)


def record(exchange: Exchange, address: str, options: argparse.Namespace) -> None:
    """One exchange from the first heartbeat to the saved file."""
    mode_names = VEHICLES[options.vehicle].mode_names
    link = VehicleLink(address, mode_names)
    try:
        link.wait_until("first HEARTBEAT", lambda: link.system_id != 0, 30)
        link.log_heartbeats = exchange.log_heartbeats
        if not exchange.from_power_up:
            link.request_rates()
            for name, value in exchange.parameters.items():
                link.set_parameter(name, value)
        link.transcript = Transcript(options.out / f"{exchange.name}.jsonl", mode_names, link.clock)
        try:
            exchange.run(link)
        finally:
            link.transcript.save()
    finally:
        link.close()


def record_with_sitl(exchange: Exchange, port: int, options: argparse.Namespace) -> str | None:
    """One exchange with a vehicle of its own; what went wrong, or None."""
    try:
        with (
            tempfile.TemporaryDirectory() as folder,
            running(options, port, folder, exchange.boot_parameters),
        ):
            record(exchange, f"udpin:127.0.0.1:{port}", options)
    except Exception as problem:  # one broken exchange must not cost the others
        print(f"{exchange.name}: FAILED: {problem}", flush=True)
        return f"{exchange.name}: {problem}"
    print(f"{exchange.name}: recorded", flush=True)
    return None


def record_all_with_sitl(selected: list[Exchange], options: argparse.Namespace) -> list[str]:
    """All of them, `jobs` at a time, each on ports of its own; the failures."""
    ports = [options.first_port + 2 * index for index in range(len(selected))]
    with ThreadPoolExecutor(max_workers=options.jobs) as pool:
        attempts = [
            pool.submit(record_with_sitl, exchange, port, options)
            for exchange, port in zip(selected, ports, strict=True)
        ]
    return [problem for attempt in attempts if (problem := attempt.result()) is not None]


def main() -> int:
    """0 when every exchange was recorded."""
    options = arguments()
    selected = chosen(VEHICLES[options.vehicle], options.only)
    if options.list:
        for exchange in selected:
            print(f"{exchange.name}: {exchange.shows}")
        return 0
    if options.sitl:
        return 1 if record_all_with_sitl(selected, options) else 0
    if len(selected) != 1:
        sys.exit("--connect records one exchange with one vehicle: name it with --only")
    record(selected[0], options.connect, options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
