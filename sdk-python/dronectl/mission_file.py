"""Missions in files: Dronemap's own items as JSON, plans of QGroundControl, and "QGC WPL 110" of Mission Planner."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from dronectl.failure import BadFile
from dronectl.reading import content, fitted, json_of
from dronemap.contract.models import (
    LandItem,
    LookAheadItem,
    LookAtItem,
    MissionItemRequest,
    ReturnToLaunchItem,
    SetServoItem,
    TakeOffItem,
    TakePhotoItem,
    WaitItem,
    WaypointItem,
)

_FIRST_LINE = "QGC WPL 110"
_HOME_FRAMES = (3, 6)
_AMSL_FRAMES = (0, 5)


@dataclass
class MissionFile:
    """The items of a mission, and what of its file is not taken over."""

    items: list[MissionItemRequest]
    left_out: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Step:
    """An item as MAVLink has it. `parameters` are the seven of a command; the last three are the place."""

    number: int
    command: int
    frame: int
    parameters: tuple[float, ...]


def read_mission(file: Path) -> MissionFile:
    """By what stands in the file, not by its name."""
    raw = content(file)
    if raw.lstrip().startswith(_FIRST_LINE.encode()):
        return MissionFile(_items(file, _lines(file, raw.decode(errors="replace"))))
    given = json_of(file, raw)
    if isinstance(given, dict) and given.get("fileType") == "Plan":
        return _plan(file, given)
    items = given.get("items") if isinstance(given, dict) else given
    if not isinstance(items, list) or not items:
        raise BadFile(f'{file} has no items: it must be a list of them, or an object with "items".')
    return MissionFile(fitted(file, items, list[MissionItemRequest]))


def _plan(file: Path, given: dict[str, Any]) -> MissionFile:
    mission = given.get("mission")
    items = mission.get("items") if isinstance(mission, dict) else None
    if not isinstance(items, list) or not items:
        raise BadFile(f"{file} has no mission items.")
    steps = [_simple(file, number, item) for number, item in enumerate(items, 1)]
    fence, rally = given.get("geoFence") or {}, given.get("rallyPoints") or {}
    left_out = []
    if fence.get("polygons") or fence.get("circles"):
        left_out.append("its fence is not taken over")
    if rally.get("points"):
        left_out.append("its rally points are not taken over")
    return MissionFile(_items(file, steps), left_out)


def _simple(file: Path, number: int, item: Any) -> Step:
    if not isinstance(item, dict) or item.get("type") != "SimpleItem":
        kind = item.get("complexItemType", "pattern") if isinstance(item, dict) else "something else"
        raise BadFile(f"{file}: item {number} is a {kind}; only single steps can be read.")
    try:
        parameters = tuple(0.0 if value is None else float(value) for value in item["params"])
        step = Step(number, int(item["command"]), int(item["frame"]), parameters)
    except (KeyError, TypeError, ValueError) as e:
        raise BadFile(f"{file}: item {number} cannot be read: {e}") from e
    if len(parameters) != 7:
        raise BadFile(f"{file}: item {number} has {len(parameters)} parameters instead of 7.")
    return step


def _lines(file: Path, text: str) -> list[Step]:
    steps = []
    for number, line in enumerate(text.splitlines()[1:], 2):
        if not line.strip():
            continue
        words = line.split()
        try:
            index, current, frame, command = (int(word) for word in words[:4])
            parameters = tuple(float(word) for word in words[4:11])
        except ValueError as e:
            raise BadFile(f"{file}: line {number} cannot be read: {e}") from e
        if len(parameters) != 7:
            raise BadFile(f"{file}: line {number} has {len(words)} columns instead of 12.")
        # Mission Planner writes home as the first item, which is none of the mission.
        if not (index == 0 and current == 1 and command == 16 and frame == 0):
            steps.append(Step(number, command, frame, parameters))
    if not steps:
        raise BadFile(f"{file} has no mission items.")
    return steps


def _items(file: Path, steps: list[Step]) -> list[MissionItemRequest]:
    items: list[MissionItemRequest] = []
    for step in steps:
        items.extend(_item(file, step, items))
    return items


def _item(file: Path, step: Step, before: list[MissionItemRequest]) -> list[MissionItemRequest]:
    first, second = step.parameters[0], step.parameters[1]
    match step.command:
        case 16:
            return [_waypoint(file, step, hold_seconds=first or None)]
        case 19:
            return [_waypoint(file, step, hold_seconds=first)]
        case 22:
            if step.frame not in _HOME_FRAMES:
                raise _refused(file, step, "its altitude must be above home")
            return [TakeOffItem(altitude=step.parameters[6])]
        case 21:
            return [*_over(file, step, before), LandItem()]
        case 20:
            return [ReturnToLaunchItem()]
        case 93:
            return [WaitItem(hold_seconds=first)]
        case 183:
            return [SetServoItem(output=int(first), pulse=int(second))]
    return [_of_camera(file, step)]


def _of_camera(file: Path, step: Step) -> MissionItemRequest:
    match step.command:
        case 203:
            return TakePhotoItem()
        case 2000 if step.parameters[2] == 1:
            return TakePhotoItem()
        case 195 | 201:
            at = _waypoint(file, step)
            return LookAtItem(
                latitude=at.latitude,
                longitude=at.longitude,
                altitude=at.altitude,
                altitude_reference=at.altitude_reference,
            )
        case 197:
            return LookAheadItem()
    raise _refused(file, step, "Dronemap has no step for it")


def _waypoint(file: Path, step: Step, hold_seconds: float | None = None) -> WaypointItem:
    if step.frame not in (*_HOME_FRAMES, *_AMSL_FRAMES):
        raise _refused(file, step, f"its altitude is of frame {step.frame}, neither above home nor above sea level")
    _, _, _, _, latitude, longitude, altitude = step.parameters
    if not (-90 <= latitude <= 90 and -180 <= longitude <= 180) or (latitude == 0 and longitude == 0):
        raise _refused(file, step, f"it has no place ({latitude:g}, {longitude:g})")
    return WaypointItem(
        latitude=latitude,
        longitude=longitude,
        altitude=altitude,
        altitude_reference="home" if step.frame in _HOME_FRAMES else "amsl",
        hold_seconds=hold_seconds,
    )


def _over(file: Path, step: Step, before: list[MissionItemRequest]) -> list[MissionItemRequest]:
    """A landing at a place: vehicles fly there as high as they are, and land then."""
    latitude, longitude = step.parameters[4], step.parameters[5]
    if latitude == 0 and longitude == 0:
        return []
    for item in reversed(before):
        if isinstance(item, WaypointItem):
            return [item.model_copy(update={"latitude": latitude, "longitude": longitude, "hold_seconds": None})]
        if isinstance(item, TakeOffItem):
            return [WaypointItem(latitude=latitude, longitude=longitude, altitude=item.altitude)]
    raise _refused(file, step, "nothing before it says how high the drone flies to where it lands")


def _refused(file: Path, step: Step, why: str) -> BadFile:
    return BadFile(f"{file}: item or line {step.number} (MAVLink command {step.command}) cannot be taken over: {why}.")
