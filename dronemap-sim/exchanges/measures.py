#!/usr/bin/env python3
"""The key figures of the recordings: prints them as a Markdown table and writes recorded/measured.json.

With --compare FOLDER the same figures are taken from other recordings (a simulator's) and held against that file:
they agree when each lies within `tolerance`; exit code 1 when one does not or cannot be taken.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import sys
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

from recorded_lines import (
    Lines,
    between,
    in_mode,
    landed,
    last_seconds_of,
    load,
    seconds,
    seconds_of,
    sent,
    status_text,
    values,
)

RECORDED = Path(__file__).parent / "recorded"
METERS_PER_DEGREE = 111_319.5


@dataclass(frozen=True)
class Measure:
    """One figure: key, meaning, unit, tolerance, exchange, and the function that computes it."""

    key: str
    meaning: str
    unit: str
    tolerance: float
    exchange: str
    of: Callable[[Lines], float]


@dataclass(frozen=True)
class Figure:
    """Entry of measured.json for one measure."""

    value: float
    unit: str
    tolerance: float
    exchange: str
    meaning: str


def acknowledgement_seconds(lines: Lines) -> float:
    """The median time from a command to its acknowledgement."""
    waiting: dict[int, float] = {}
    delays = []
    for line in lines:
        if line["msg"] in ("COMMAND_LONG", "COMMAND_INT"):
            waiting[line["command"]] = seconds(line)
        elif line["msg"] == "COMMAND_ACK" and line["command"] in waiting:
            delays.append(seconds(line) - waiting.pop(line["command"]))
    return statistics.median(delays)


def takeoff_overshoot(lines: Lines) -> float:
    """Metres above 20 m that it rose to."""
    return max(values(lines, "GLOBAL_POSITION_INT", "relative_alt")) / 1000 - 20


def descent_rate(lines: Lines, low_meters: float, high_meters: float) -> float:
    """The median rate of sinking between two heights, after LANDING began."""
    started = seconds_of(lines, **landed(4))
    rates = [
        float(line["vz"]) / 100
        for line in lines
        if line["msg"] == "GLOBAL_POSITION_INT"
        and seconds(line) > started
        and low_meters * 1000 < line["relative_alt"] < high_meters * 1000
    ]
    return statistics.median(rates)


def top_speed(lines: Lines) -> float:
    """The highest ground speed seen."""
    return max(values(lines, "VFR_HUD", "groundspeed"))


def second_leg_speed(lines: Lines) -> float:
    """The highest ground speed from 2 s after the second setpoint on."""
    legs = [seconds(line) for line in lines if line["msg"] == "SET_POSITION_TARGET_GLOBAL_INT"]
    return max(values(lines, "VFR_HUD", "groundspeed", legs[1] + 2))


def highest(lines: Lines) -> float:
    """The greatest height above home, in metres."""
    return max(values(lines, "GLOBAL_POSITION_INT", "relative_alt")) / 1000


def seconds_to_speed(lines: Lines, meters_per_second: float) -> float:
    """From the first line to this ground speed."""
    for line in lines:
        if line["msg"] == "VFR_HUD" and line["groundspeed"] >= meters_per_second:
            return seconds(line)
    raise LookupError(f"never reached {meters_per_second} m/s")


def northward_run(lines: Lines, start: float, end: float) -> float:
    """Metres flown to the north within a time."""
    latitudes = values(lines, "GLOBAL_POSITION_INT", "lat", start, end)
    return (latitudes[-1] - latitudes[0]) * 1e-7 * METERS_PER_DEGREE


def stopping_distance(lines: Lines) -> float:
    """Metres flown on after the command to pause."""
    asked = seconds_of(lines, **sent(193))
    return northward_run(lines, asked, asked + 6)


def loiter_sink_rate(lines: Lines) -> float:
    """Sinking in LOITER with the throttle stick at the bottom, as it is with no pilot."""
    started = seconds_of(lines, **in_mode("LOITER"))
    return max(values(lines, "GLOBAL_POSITION_INT", "vz", started, started + 6)) / 100


def silence_before_failsafe(lines: Lines) -> float:
    """From the last heartbeat sent to the text."""
    acted = seconds_of(lines, **status_text("GCS Failsafe"))
    return acted - last_seconds_of(lines, acted, dir="to", msg="HEARTBEAT")


def request_interval(lines: Lines) -> float:
    """Seconds between requests for a missing mission item."""
    asked = [seconds(line) for line in lines if line["msg"] == "MISSION_REQUEST" and line["seq"] == 2]
    repeats = asked[-6:]
    return statistics.median(later - earlier for earlier, later in pairwise(repeats))


def upload_timeout(lines: Lines) -> float:
    """From the last item taken to the acknowledgement that gives up."""
    gave_up = seconds_of(lines, msg="MISSION_ACK", type=15)
    return gave_up - last_seconds_of(lines, gave_up, msg="MISSION_ITEM_INT")


def upload_seconds(lines: Lines) -> float:
    """From MISSION_COUNT to MISSION_ACK, six items."""
    return between(lines, {"dir": "to", "msg": "MISSION_COUNT"}, {"dir": "from", "msg": "MISSION_ACK"})


def time_in_air_of_leg(lines: Lines) -> float:
    """From the first setpoint until within a metre of the target 150 m north."""
    target = next(line["lat_int"] for line in lines if line["msg"] == "SET_POSITION_TARGET_GLOBAL_INT")
    near = 1e7 / METERS_PER_DEGREE
    for line in lines:
        if line["msg"] == "GLOBAL_POSITION_INT" and abs(line["lat"] - target) < near:
            return seconds(line)
    raise LookupError("never arrived")


def last_setpoint_at(lines: Lines) -> float:
    """Seconds at which the last setpoint was sent."""
    return last_seconds_of(lines, math.inf, msg="SET_POSITION_TARGET_GLOBAL_INT")


def speed_behind_setpoint(lines: Lines) -> float:
    """The ground speed when it has caught up with the place that moves."""
    end = last_setpoint_at(lines)
    return statistics.median(values(lines, "VFR_HUD", "groundspeed", end - 7, end))


def distance_behind_setpoint(lines: Lines) -> float:
    """Metres that it is south of the last setpoint, when it has caught up."""
    end = last_setpoint_at(lines)
    place, behind = 0.0, []
    for line in lines:
        if line["msg"] == "SET_POSITION_TARGET_GLOBAL_INT":
            place = float(line["lat_int"])
        elif line["msg"] == "GLOBAL_POSITION_INT" and end - 7 <= seconds(line) <= end:
            behind.append((place - float(line["lat"])) * 1e-7 * METERS_PER_DEGREE)
    return statistics.median(behind)


def heading_behind_setpoint(lines: Lines) -> float:
    """The heading while it follows the setpoints."""
    end = last_setpoint_at(lines)
    return statistics.median(values(lines, "VFR_HUD", "heading", end - 7, end))


def distance_after_last_setpoint(lines: Lines) -> float:
    """Metres from the last setpoint to where it stands in the end, to the north."""
    places = values(lines, "SET_POSITION_TARGET_GLOBAL_INT", "lat_int")
    return (values(lines, "GLOBAL_POSITION_INT", "lat")[-1] - places[-1]) * 1e-7 * METERS_PER_DEGREE


def stopping_time_after_last_setpoint(lines: Lines) -> float:
    """Seconds from the last setpoint until it has slowed down to 1 m/s."""
    end = last_setpoint_at(lines)
    for line in lines:
        if line["msg"] == "VFR_HUD" and seconds(line) > end and line["groundspeed"] < 1:
            return seconds(line) - end
    raise LookupError("never stood")


def overshoot_after_last_setpoint(lines: Lines) -> float:
    """Metres that it flew past where it stands in the end."""
    latitudes = values(lines, "GLOBAL_POSITION_INT", "lat")
    return (max(latitudes) - latitudes[-1]) * 1e-7 * METERS_PER_DEGREE


def fall_speed(lines: Lines) -> float:
    """The fastest sinking."""
    return max(values(lines, "GLOBAL_POSITION_INT", "vz")) / 100


def turned_degrees(lines: Lines) -> float:
    """Heading change after two copies of a relative turn by 30 degrees."""
    first = seconds_of(lines, **sent(115))
    headings = values(lines, "VFR_HUD", "heading", first - 1.5, first + 6)
    return (headings[-1] - headings[0]) % 360


def seconds_after_parameter(text: str) -> Callable[[Lines], float]:
    """From the PARAM_SET that makes the fault to a text."""
    return lambda lines: between(lines, {"dir": "to", "msg": "PARAM_SET"}, status_text(text))


MEASURES: tuple[Measure, ...] = (
    Measure("acknowledgementSeconds", "command → COMMAND_ACK (median)", "s", 0.2, "commands_odd",
            acknowledgement_seconds),
    Measure("homeSetSeconds", "power-up → HOME_POSITION, origin set", "s", 5, "arming_refused",
            lambda lines: seconds_of(lines, msg="HOME_POSITION")),
    Measure("armingGrantedSeconds", "power-up → arming granted, asked for every 5 s", "s", 6,
            "arming_refused", lambda lines: seconds_of(lines, msg="COMMAND_ACK", command=400, result=0)),
    Measure("groundDisarmSeconds", "armed on the ground and nothing done → disarms itself (DISARM_DELAY)", "s", 1,
            "arm_and_disarm", lambda lines: seconds_of(lines, after=5, **status_text("Disarming motors"))
            - seconds_of(lines, after=5, **status_text("Arming motors"))),
    Measure("spoolUpSeconds", "take-off command → landed_state TAKEOFF, it leaves the ground", "s", 0.5,
            "guided_takeoff", lambda lines: between(lines, sent(22), landed(3))),
    Measure("takeoffSeconds", "take-off command → landed_state IN_AIR at 20 m", "s", 1.5, "guided_takeoff",
            lambda lines: between(lines, sent(22), landed(2))),
    Measure("climbRate", "highest rate of climb in take-off (WPNAV_SPEED_UP)", "m/s", 0.3, "guided_takeoff",
            lambda lines: max(values(lines, "VFR_HUD", "climb"))),
    Measure("takeoffOvershoot", "above the 20 m asked for, at most", "m", 0.5, "guided_takeoff", takeoff_overshoot),
    Measure("landingSeconds", "NAV_LAND at 20 m → landed_state ON_GROUND", "s", 3, "guided_takeoff",
            lambda lines: between(lines, sent(21), landed(1))),
    Measure("descentRateHigh", "sinking above 10 m while landing (WPNAV_SPEED_DN)", "m/s", 0.2, "guided_takeoff",
            lambda lines: descent_rate(lines, 12, 18)),
    Measure("descentRateLow", "sinking below 10 m while landing (LAND_SPEED)", "m/s", 0.1, "guided_takeoff",
            lambda lines: descent_rate(lines, 1, 8)),
    Measure("onGroundToDisarmSeconds", "landed_state ON_GROUND after landing → “Disarming motors”", "s", 0.5,
            "guided_takeoff",
            lambda lines: between(lines, landed(4), status_text("Disarming motors"))
            - between(lines, landed(4), landed(1))),
    Measure("cruiseSpeed", "highest ground speed on a 150 m leg in GUIDED (WPNAV_SPEED)", "m/s", 0.5,
            "go_to_by_setpoint", top_speed),
    Measure("legSeconds", "150 m leg, from rest to within a metre", "s", 2, "go_to_by_setpoint", time_in_air_of_leg),
    Measure("secondsTo9MetersPerSecond", "from rest to 9 m/s", "s", 1.5, "go_to_by_setpoint",
            lambda lines: seconds_to_speed(lines, 9)),
    Measure("ledSpeed", "led by a place that moves at 5 m/s: ground speed", "m/s", 0.3, "led_by_places",
            speed_behind_setpoint),
    Measure("ledBehind", "the same: metres behind the place said last", "m", 1, "led_by_places",
            distance_behind_setpoint),
    Measure("ledHeading", "the same: heading, told to look east", "°", 5, "led_by_places", heading_behind_setpoint),
    Measure("leftAloneMeters", "the same, not a word more: metres on from the last place", "m", 3, "led_by_places",
            distance_after_last_setpoint),
    Measure("leftAloneOvershoot", "the same: metres past where it stands in the end", "m", 3, "led_by_places",
            overshoot_after_last_setpoint),
    Measure("leftAloneSeconds", "the same: until slower than 1 m/s", "s", 2, "led_by_places",
            stopping_time_after_last_setpoint),
    Measure("stoppingDistance", "DO_PAUSE_CONTINUE at 10 m/s: metres flown on", "m", 8, "hold_in_flight",
            stopping_distance),
    Measure("loiterSinkRate", "sinking in LOITER with the throttle stick down (no pilot)", "m/s", 0.4,
            "hold_in_flight", loiter_sink_rate),
    Measure("changedSpeed", "highest ground speed on a leg begun after DO_CHANGE_SPEED 3 m/s in GUIDED", "m/s", 0.3,
            "speed_and_home", second_leg_speed),
    Measure("changedSpeedLost", "the same, asked for before the first go-to since take-off: lost", "m/s", 1,
            "speed_and_home", top_speed),
    Measure("uploadSeconds", "six items, MISSION_COUNT → MISSION_ACK", "s", 0.5, "mission_upload", upload_seconds),
    Measure("itemRequestSeconds", "a missing item is asked for again every", "s", 0.3, "mission_upload_refused",
            request_interval),
    Measure("uploadTimeoutSeconds", "last item → upload given up", "s", 1, "mission_upload_refused", upload_timeout),
    Measure("missionSeconds", "MISSION_START → disarmed, six items", "s", 8, "mission_flight",
            lambda lines: between(lines, sent(300), {"msg": "HEARTBEAT", "armed": False})),
    Measure("missionTakeoffSeconds", "MISSION_START → item 1 reached", "s", 1.5, "mission_flight",
            lambda lines: between(lines, sent(300), {"msg": "MISSION_ITEM_REACHED", "seq": 1})),
    Measure("missionRtlLoiterSeconds", "item 4 reached → landing begins (back 40 m, 5 s over home)", "s", 4,
            "mission_flight", lambda lines: between(lines, {"msg": "MISSION_ITEM_REACHED", "seq": 4}, landed(4))),
    Measure("rtlHeightFromBelow", "RTL from 8 m: height flown home at (RTL_ALT)", "m", 0.5, "rtl_from_8_m", highest),
    Measure("rtlHeightFromAbove", "RTL from 20 m: height flown home at", "m", 0.5, "rtl_from_20_m", highest),
    Measure("rtlToLandingSeconds", "RTL 60 m away at 20 m → landing begins", "s", 3, "rtl_from_20_m",
            lambda lines: between(lines, sent(20), landed(4))),
    Measure("rtlOverHomeSeconds", "RTL straight above home → landing begins (RTL_LOIT_TIME 5 s)", "s", 1.5,
            "rtl_close_to_home", lambda lines: between(lines, sent(176), landed(4))),
    Measure("batteryLowSeconds", "voltage under BATT_LOW_VOLT → “Battery Failsafe” (BATT_LOW_TIMER)", "s", 1.5,
            "battery_low", seconds_after_parameter("Battery Failsafe")),
    Measure("groundStationLostSeconds", "last heartbeat → “GCS Failsafe”, RTL", "s", 1.2, "ground_station_lost",
            silence_before_failsafe),
    Measure("gpsLostSeconds", "GPS gone → “EKF Failsafe: changed to LAND Mode”", "s", 2, "gps_lost",
            seconds_after_parameter("EKF Failsafe: changed to LAND Mode")),
    Measure("gpsBackSeconds", "GPS back → “EKF Failsafe Cleared”; stays in LAND", "s", 2, "gps_lost",
            lambda lines: between(lines, {"dir": "to", "msg": "PARAM_SET", "param_value": 0},
                                  status_text("EKF Failsafe Cleared"))),
    Measure("fallSpeed", "motor failed: fastest sinking on the way down from 30 m", "m/s", 4, "motor_failure",
            fall_speed),
    Measure("thrustLossSeconds", "motor failed → “Potential Thrust Loss (1)”", "s", 3, "motor_failure",
            seconds_after_parameter("Potential Thrust Loss")),
    Measure("hoverAmperes", "current in the hover at 20 m, 12.6 V, 3.3 Ah", "A", 4, "guided_takeoff",
            lambda lines: statistics.median(values(lines, "SYS_STATUS", "current_battery", 8, 45)) / 100),
    Measure("turnedDegrees", "two copies of CONDITION_YAW 30° relative turn by", "°", 5, "commands_twice",
            turned_degrees),
)  # fmt: skip


def evaluate(measure: Measure, folder: Path) -> Figure:
    """One measure of one folder of recordings."""
    value = measure.of(load(folder, measure.exchange))
    return Figure(round(value, 3), measure.unit, measure.tolerance, measure.exchange, measure.meaning)


def figures(folder: Path) -> dict[str, Figure]:
    """All measures taken."""
    return {measure.key: evaluate(measure, folder) for measure in MEASURES}


def verdict(measure: Measure, folder: Path, reference: Mapping[str, Any]) -> tuple[bool, str]:
    """True and a line when the other recording agrees; false and why not."""
    expected, tolerance, unit = reference["value"], reference["tolerance"], reference["unit"]
    try:
        value = evaluate(measure, folder).value
    except (FileNotFoundError, LookupError, ValueError, statistics.StatisticsError) as problem:
        return False, f"{measure.key}: cannot be taken: {problem}"
    agrees = abs(value - expected) <= tolerance
    return agrees, f"{measure.key}: {value:g} {unit}, expected {expected:g} ± {tolerance:g}{'' if agrees else '  ✗'}"


def compare(folder: Path) -> int:
    """Say of every figure whether it agrees; 1 when one does not."""
    references = json.loads((RECORDED / "measured.json").read_text(encoding="utf-8"))
    verdicts = [verdict(measure, folder, references[measure.key]) for measure in MEASURES]
    for _, line in verdicts:
        print(line)
    missed = sum(not agrees for agrees, _ in verdicts)
    print(f"{len(verdicts) - missed} figures agree, {missed} do not")
    return 1 if missed else 0


def table(figures_by_key: Mapping[str, Figure]) -> str:
    """The figures as Markdown."""
    rows = ["| figure | measured | tolerance | exchange | key |", "| --- | ---: | ---: | --- | --- |"]
    for key, figure in figures_by_key.items():
        value, tolerance = f"{figure.value:.2f} {figure.unit}", f"± {figure.tolerance:g} {figure.unit}"
        rows.append(f"| {figure.meaning} | {value} | {tolerance} | `{figure.exchange}` | `{key}` |")
    return "\n".join(rows)


def main() -> int:
    """Print the table and write measured.json, or compare."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compare", type=Path, metavar="FOLDER", help="recordings to hold against measured.json")
    folder: Path | None = parser.parse_args().compare
    if folder is not None:
        return compare(folder)
    figures_by_key = figures(RECORDED)
    content = json.dumps({key: asdict(figure) for key, figure in figures_by_key.items()}, indent=1, ensure_ascii=False)
    (RECORDED / "measured.json").write_text(content + "\n", encoding="utf-8")
    print(table(figures_by_key))
    return 0


if __name__ == "__main__":
    sys.exit(main())
