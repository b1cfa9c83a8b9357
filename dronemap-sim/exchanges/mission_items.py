#!/usr/bin/env python3
"""Record which mission items a freshly started ArduPilot takes, and how it gives each of them back.

First one JSON line for each content that was sent, then one for each command with it: the type of the MISSION_ACK, and
what was read back if it was taken.
"""

from __future__ import annotations

import argparse
import json
import math
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import astuple, dataclass, replace
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from missions import next_mission_message, send_count
from record_exchanges import running
from transcript import plain
from vehicle_link import VehicleLink
from vehicles import VEHICLES

NAN = float("nan")
FIRST_NOT_FLOWN = 95
ACCEPTED = int(mavlink.MAV_MISSION_ACCEPTED)
FIELDS = ("frame", "param1", "param2", "param3", "param4", "x", "y", "z")
ITEMS = Path(__file__).parent / "items"


@dataclass(frozen=True)
class Content:
    """All that an item has beside its command: degrees × 10⁷, metres."""

    frame: int
    param1: float
    param2: float
    param3: float
    param4: float
    x: int
    y: int
    z: float


HOME = Content(0, 0, 0, 0, 0, 0, 0, 0)
WHOLE = Content(3, 7, 2, 3, 4, -353_600_000, 1_491_700_000, 30)

# Sent of each command: the first says whether it is known at all.
CONTENTS: Mapping[str, Content] = {
    "whole": WHOLE,
    "fractions": Content(3, 2.5, 3.75, 1.25, 45.5, -353_600_001, 1_491_700_001, 30.256),
    "zero": Content(3, 0, 0, 0, 0, 0, 0, 0),
    "negative": Content(3, -1, -2, -3, -4, -353_600_000, 1_491_700_000, -5.5),
    "large": Content(0, 300, 700, 70_000, 400, -353_600_000, 1_491_700_000, 700),
    "without a place": replace(WHOLE, x=0, y=0),
    "over terrain": replace(WHOLE, frame=10),
    "relative, INT": replace(WHOLE, frame=6),
    "in no frame": replace(WHOLE, frame=2),
    "NaN first": replace(WHOLE, param1=NAN),
    "NaN second": replace(WHOLE, param2=NAN),
    "NaN third": replace(WHOLE, param3=NAN),
    "NaN fourth": replace(WHOLE, param4=NAN),
    "NaN height": replace(WHOLE, z=NAN),
    "off the earth": replace(WHOLE, x=950_000_000),
}


def commands() -> list[int]:
    """All that the dialect names, and one that it does not."""
    return sorted({*mavlink.enums["MAV_CMD"], 31_000} - {mavlink.MAV_CMD_ENUM_END})


def upload(link: VehicleLink, command: int, content: Content) -> int:
    """Home and one item; the type of the acknowledgement."""
    link.clear_inbox()
    send_count(link, 2)
    while True:
        message = next_mission_message(link)
        if message.get_type() == "MISSION_ACK":
            return int(message.type)
        item = (
            (mavlink.MAV_CMD_NAV_WAYPOINT, Content(0, 0, 0, 0, 0, 0, 0, 0)) if message.seq == 0 else (command, content)
        )
        frame, *values = astuple(item[1])
        link.send(
            mavlink.MAVLink_mission_item_int_message(link.system_id, 1, message.seq, frame, item[0], 0, 1, *values)
        )


def read_back(link: VehicleLink) -> dict[str, Any]:
    """Item 1 as the vehicle has it."""
    link.clear_inbox()
    link.send(mavlink.MAVLink_mission_request_int_message(link.system_id, 1, 1))
    item = link.expect("item 1", lambda m: m.get_type() == "MISSION_ITEM_INT", 5)
    return {f"read_{name}": number(getattr(item, name)) for name in ("command", *FIELDS)}


def number(value: float) -> Any:
    """As JSON has it: what is no number, or beyond all, becomes null."""
    return plain(value) if math.isfinite(value) else None


def recorded(link: VehicleLink) -> Iterator[dict[str, Any]]:
    """The contents, then one line an item; of a command that is not known no more than the first."""
    for name, content in CONTENTS.items():
        values = zip(FIELDS, astuple(content), strict=True)
        yield {"content": name, **{field: number(value) for field, value in values}}
    for command in commands():
        for name, content in CONTENTS.items():
            if name == "NaN height" and command >= FIRST_NOT_FLOWN:
                continue  # a number that is no height is turned into an integer: the simulated processor stops
            ack = upload(link, command, content)
            line = {"command": command, "sent": name, "ack": ack}
            yield {**line, **read_back(link)} if ack == ACCEPTED else line
            if ack == mavlink.MAV_MISSION_UNSUPPORTED and content is WHOLE:
                break


def main() -> None:
    """Start the vehicle, ask, write the file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sitl", type=Path, required=True, metavar="PATH", help="the binary of the vehicle")
    parser.add_argument("--vehicle", choices=VEHICLES, default="copter", help="which one it is (default copter)")
    parser.add_argument(
        "--defaults", type=Path, help="parameter defaults (default: copter.parm and the like beside it)"
    )
    parser.add_argument("--port", type=int, default=15_700, help="two UDP ports from here on (default 15700)")
    parser.add_argument("--out", type=Path, default=ITEMS / "arducopter.jsonl", help="the file to write")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, running(options, options.port, folder):
        link = VehicleLink(f"udpin:127.0.0.1:{options.port}", VEHICLES[options.vehicle].mode_names)
        try:
            link.wait_until("first HEARTBEAT", lambda: link.system_id != 0, 30)
            link.pump_for(5)
            lines = list(recorded(link))
        finally:
            link.close()
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")


if __name__ == "__main__":
    main()
