"""Judges by recorded datagrams that no drone stays in the air without controller, mission or return."""

import math
from dataclasses import dataclass, field

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .control_loss_cases import OPERATIONS, STEERED, LossCase
from .datagram_recorder import Log, State, TimedMessage

AUTO, GUIDED, RTL, LAND = 3, 4, 6, 9
HOMEWARD = (RTL, LAND)
# Slack on every limit: two cores that do much else, news that comes once a second.
SLACK = 8.0
# What a server that is killed had sent comes within that.
IN_FLIGHT = 0.3
# After that the mode that a pilot chose was visible at the server.
NOTICED = 1.0
# From its way home to its motors off, from where these vehicles can be.
DOWN = 90.0
# No heartbeat of a server that is there comes later than this after the one before.
BEAT = 4.0
# After its time a setpoint leads nowhere: half a second, and what was on its way.
LEADS = 2.0
STANDS = 0.5
UP_METRES = 1.0
# After a restart, who took control has so long to come back before being silent counts.
RETURNING = 15.0

READS = {
    mavlink.MAV_CMD_SET_MESSAGE_INTERVAL,
    mavlink.MAV_CMD_REQUEST_MESSAGE,
    mavlink.MAV_CMD_GET_HOME_POSITION,
    mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES,
}
# What may be said to a vehicle that a pilot has; all else is forbidden.
ALLOWED_BESIDE_PILOT = {
    *("HEARTBEAT", "TIMESYNC", "PING", "SYSTEM_TIME", "REQUEST_DATA_STREAM"),
    *("PARAM_REQUEST_READ", "PARAM_REQUEST_LIST", "LOG_REQUEST_LIST"),
    *("MISSION_REQUEST_LIST", "MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ACK"),
}


@dataclass(frozen=True)
class Limits:
    """Time limits as the server and the follows are set, in seconds."""

    lost: float
    idle: float
    until_return: float
    patience: float


@dataclass
class LossRecord:
    """Events of one drone and its server; monotonic seconds, infinite: it did not happen."""

    # The last sign of its controller, or the loss of control.
    lost_at: float
    # From when to when no server was there, or none that moved.
    server_away: tuple[float, float] = (math.inf, math.inf)
    stood_still: bool = False
    # A pilot chose a mode at the vehicle.
    piloted_at: float = math.inf
    # Places that were commanded before the server stood still, and were to be forgotten since: degrees 1e7.
    expired_targets: list[tuple[int, int]] = field(default_factory=list)
    observed_until: float = math.inf
    # A sign that came after a standstill was taken for one in time.
    kept_over_standstill: bool = False


@dataclass(frozen=True)
class Judgement:
    case: LossCase
    faults: list[str]
    # Its outcome in few words.
    summary: str


def judge(case: LossCase, log: Log, happened: LossRecord, limits: Limits) -> Judgement:
    faults, summary = [], "never in the air"
    was = log.at(happened.lost_at)
    if not was.armed or was.height < UP_METRES:
        faults.append(f"it was not in the air when it was left: {was}")
    elif happened.piloted_at < math.inf:
        faults, summary = _faults_beside_pilot(log, happened)
    else:
        faults, summary = _faults_without_controller(case, log, happened, limits)
    faults += _expired_targets_sent(log, happened)
    if happened.kept_over_standstill:
        faults.append("control was kept over a standstill in which no sign came")
    return Judgement(case, faults, summary)


def _faults_without_controller(
    case: LossCase, log: Log, happened: LossRecord, limits: Limits
) -> tuple[list[str], str]:
    since = log.since(happened.lost_at)
    home = return_begin(since)
    if home is None:
        return [f"it never went home; last {since[-1]}"], "stayed"
    faults = []
    limit = unattended_limit(case, happened, limits)
    alone = unattended_seconds(since, home.at)
    if alone > limit:
        faults.append(
            f"it waited for {alone:.1f} s in the air before it went home, not {limit:.1f} s at most"
        )
    down = next((state for state in since if state.at >= home.at and not state.armed), None)
    if down is None:
        faults.append(f"it went home and is not down; last {since[-1]}")
    elif down.at - home.at > DOWN:
        faults.append(f"it was down {down.at - home.at:.1f} s after it went home, not within {DOWN:.0f} s")
    faults += _steered_after_loss(case, log, happened)
    landed = "?" if down is None else f"{down.at - happened.lost_at:.1f} s"
    return (
        faults,
        f"home after {home.at - happened.lost_at:.1f} s (alone {alone:.1f} of {limit:.0f}), down {landed}",
    )


def unattended_limit(case: LossCase, happened: LossRecord, limits: Limits) -> float:
    """For so long it may be in the air with nobody, no mission under way and no way home."""
    begin, end = happened.server_away
    over = limits.until_return + SLACK
    if case.kind in OPERATIONS:
        wait = max(limits.patience, over)
    elif case.event in ("vanish", "sign out", "revoke", "hand over"):
        # What was taken away ends at once, or when no sign comes any more.
        wait = max(limits.lost, limits.idle)
    else:
        wait = 0.0
    if begin is math.inf or begin - happened.lost_at > wait + over:
        return wait + over
    if happened.stood_still:
        # All times went by meanwhile, but for that from the lapse that is seen then to the return.
        return end - happened.lost_at + over + (wait if case.kind in OPERATIONS else 0)
    back = RETURNING + limits.lost if case.explicit and case.event != "hand over" else 0.0
    return end - happened.lost_at + wait + back + over


def return_begin(states: list[State]) -> State | None:
    """From when on it was on its way home or down until it was there; None: never, or not for good."""
    found: State | None = None
    for state in states:
        if not state.armed:
            return found or state
        if state.mode not in HOMEWARD:
            found = None
        elif found is None:
            found = state
    return found


def unattended_seconds(states: list[State], observed_until: float) -> float:
    """Seconds in the air without a controller; those that it flies a mission do not count."""
    seconds = 0.0
    for before, after in zip(states, states[1:], strict=False):
        if before.at >= observed_until:
            break
        is_flying = before.mode == AUTO and (before.speed > STANDS)
        if not is_flying and before.armed:
            seconds += after.at - before.at
    return seconds


def _steered_after_loss(case: LossCase, log: Log, happened: LossRecord) -> list[str]:
    """Faults for setpoints that were sent after control was lost."""
    if case.kind not in STEERED:
        return []
    late = [one for one in log.sent_since(happened.lost_at + LEADS) if steers(one)]
    return [f"{late[0].at - happened.lost_at:.1f} s later it was steered on: {late[0]}"] if late else []


def steers(timed: TimedMessage) -> bool:
    message = timed.message
    if timed.kind.startswith("SET_POSITION_TARGET"):
        return any(abs(each) > 0.01 for each in (message.vx, message.vy, message.vz))
    if timed.kind == "MANUAL_CONTROL":
        return bool(message.x or message.y or message.r)
    return timed.kind == "COMMAND_INT" and message.command == mavlink.MAV_CMD_DO_REPOSITION


def _faults_beside_pilot(log: Log, happened: LossRecord) -> tuple[list[str], str]:
    begin, end = happened.server_away
    seen = pilot_visible_at(log, happened)
    if seen is None:
        return ["the vehicle never said that a pilot has it"], "?"
    # What lay in its socket when it moved again was there to be read before anything was decided.
    noticed = seen if happened.stood_still and seen == end else seen + NOTICED
    forbidden = [
        one
        for one in log.sent_since(noticed)
        if one.at < happened.observed_until and not is_allowed_beside_pilot(one)
    ]
    faults = [f"{one.at - happened.piloted_at:.1f} s after a pilot took it: {one}" for one in forbidden[:5]]
    beats = [one.at for one in log.sent_since(seen, "HEARTBEAT") if one.at < happened.observed_until]
    marks = [seen, *beats, happened.observed_until]
    for before, after in zip(marks, marks[1:], strict=False):
        gap = after - before
        if before < end and after > begin:
            # It may be slow to speak when it is back; nobody else's fail-safe waits for it.
            continue
        if gap > BEAT:
            faults.append(
                f"no heartbeat for {gap:.1f} s, {before - happened.piloted_at:.1f} s after a pilot took it"
            )
    modes = sorted(
        {
            state.mode
            for state in log.since(happened.piloted_at + NOTICED)
            if state.at < happened.observed_until
        }
    )
    seconds = happened.observed_until - seen
    summary = f"{len(forbidden)} forbidden, {len(beats)} heartbeats in {seconds:.0f} s, modes {modes}"
    return faults, summary


def pilot_visible_at(log: Log, happened: LossRecord) -> float | None:
    """When the server could know of the pilot: a heartbeat with the mode came while it ran."""
    before = log.at(happened.piloted_at).mode
    begin, end = happened.server_away
    if not happened.stood_still:
        # It is there again as soon as it speaks, long before its pages are.
        end = min((one.at for one in log.sent_since(begin + IN_FLIGHT)), default=end)
    for state in log.states:
        # What comes while it stands still lies in its socket; while there is none, vehicles speak to nobody.
        counts = state.mode != before and (happened.stood_still or not begin <= state.at < end)
        if state.at > happened.piloted_at and counts:
            return end if begin <= state.at < end else state.at
    return None


def is_allowed_beside_pilot(timed: TimedMessage) -> bool:
    if timed.kind in ("COMMAND_LONG", "COMMAND_INT"):
        return timed.message.command in READS
    return timed.kind in ALLOWED_BESIDE_PILOT


def _expired_targets_sent(log: Log, happened: LossRecord) -> list[str]:
    begin, end = happened.server_away
    if not happened.expired_targets:
        return []
    if not any(one.at <= begin for one in log.down if target(one) in happened.expired_targets):
        return ["what was to be forgotten was never said"]
    late = [one for one in log.sent_since(end) if target(one) in happened.expired_targets]
    return [
        f"{one.at - end:.1f} s after a standstill, what was commanded before it: {one}" for one in late[:3]
    ]


def target(timed: TimedMessage) -> tuple[int, int] | None:
    message = timed.message
    if timed.kind == "COMMAND_INT":
        return message.x, message.y
    if timed.kind == "SET_POSITION_TARGET_GLOBAL_INT":
        return message.lat_int, message.lon_int
    if timed.kind == "COMMAND_LONG":
        return round(message.param5 * 1e7), round(message.param6 * 1e7)
    return None
