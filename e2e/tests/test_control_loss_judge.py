"""The judge of control loss finds each fault in recorded datagrams, and none where there is none."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.control_loss_cases import LossCase
from dronemap_e2e.control_loss_judge import Limits, LossRecord, judge
from dronemap_e2e.datagram_recorder import Datagram, Log

LIMITS = Limits(lost=5, idle=5, until_return=4, patience=10)
LEFT = 100.0
AUTO, GUIDED, LOITER, RTL = 3, 4, 5, 6
STEERED = LossCase(1, "velocity", "vanish", 1.0, True, "", False)
PILOT = replace(STEERED, event="pilot", how="by switch")
VEHICLE = mavlink.MAVLink(None, srcSystem=7)
SERVER = mavlink.MAVLink(None, srcSystem=255)


def reported(at: float, mode: int, speed: float = 0.0, armed: bool = True) -> list[Datagram]:
    datagrams = [
        mavlink.MAVLink_heartbeat_message(2, 3, 1 | (128 if armed else 0), mode, 4, 3),
        mavlink.MAVLink_global_position_int_message(0, 0, 0, 0, 10_000, int(speed * 100), 0, 0, 0),
    ]
    return [Datagram(at, True, 7, bytes(one.pack(VEHICLE)), False) for one in datagrams]


def sent(at: float, message: Any) -> Datagram:
    return Datagram(at, False, 7, bytes(message.pack(SERVER)), False)


def beats(begin: int, end: int) -> list[Datagram]:
    return [sent(at, mavlink.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)) for at in range(begin, end)]


def flight(*parts: tuple[int, int, int, float]) -> list[Datagram]:
    """From when to when in which mode and how quick; down at the end."""
    states = [
        one
        for begin, end, mode, speed in parts
        for at in range(begin, end)
        for one in reported(at, mode, speed)
    ]
    return [*states, *reported(parts[-1][1], parts[-1][2], armed=False)]


def faults(case: LossCase, datagrams: Iterable[Datagram], **happened: Any) -> str:
    ordered = sorted(datagrams, key=lambda one: one.at)
    return "; ".join(judge(case, Log(ordered), LossRecord(LEFT, **happened), LIMITS).faults)


def command(number: int, *values: float) -> Any:
    values = (*values, *([0.0] * (7 - len(values))))
    return mavlink.MAVLink_command_long_message(7, 1, number, 0, *values)


def velocity(speed: float) -> Any:
    return mavlink.MAVLink_set_position_target_local_ned_message(
        *(0, 7, 1, 8, 0, 0, 0, 0, speed, 0, 0, 0, 0, 0, 0, 0)
    )


HOME_IN_TIME = flight((95, 110, GUIDED, 0), (110, 120, RTL, 3))


def test_return_in_time_has_no_fault() -> None:
    """Of the judge alone: what is right is not called wrong."""
    assert not faults(STEERED, HOME_IN_TIME)


def test_waiting_in_the_air_too_long_is_a_fault() -> None:
    """Of the judge alone: it hovers until the battery is empty, or goes home too late."""
    assert "never went home" in faults(STEERED, flight((95, 400, GUIDED, 0))[:-2])
    assert "waited for 80.0 s" in faults(STEERED, flight((95, 180, GUIDED, 0), (180, 190, RTL, 3)))
    # On its way home it was told to stay: that was no way home.
    told_to_stay = flight((95, 105, GUIDED, 0), (105, 110, RTL, 3), (110, 300, LOITER, 0), (300, 310, RTL, 3))
    assert "waited for 200.0 s" in faults(STEERED, told_to_stay)
    assert "is not down" in faults(STEERED, flight((95, 105, GUIDED, 0), (105, 190, RTL, 3))[:-2])


def test_flying_a_mission_is_not_waiting() -> None:
    """Of the judge alone: who flies a mission is not waiting, who stands at its end is."""
    mission = replace(STEERED, kind="mission")
    assert not faults(mission, flight((95, 300, AUTO, 3), (300, 310, AUTO, 0), (310, 320, RTL, 3)))
    assert "waited" in faults(mission, flight((95, 300, AUTO, 3), (300, 340, AUTO, 0), (340, 350, RTL, 3)))


def test_setpoints_after_control_loss_are_a_fault() -> None:
    """Of the judge alone: a speed that is said on is found, standing still is not."""
    assert not faults(STEERED, [*HOME_IN_TIME, sent(105, velocity(0))])
    assert "steered on" in faults(STEERED, [*HOME_IN_TIME, sent(105, velocity(1))])


def test_commands_to_piloted_vehicle_are_a_fault() -> None:
    """Of the judge alone: what may be said to it, what may not, and that the server has to be heard."""
    flown = [*flight((90, 100, GUIDED, 0), (100, 140, LOITER, 0)), *beats(90, 140)]
    alone = {"piloted_at": 99.5, "observed_until": 140.0}
    assert not faults(PILOT, [*flown, sent(120, command(mavlink.MAV_CMD_REQUEST_MESSAGE, 242))], **alone)
    assert "COMMAND_LONG" in faults(PILOT, [*flown, sent(120, command(mavlink.MAV_CMD_DO_SET_MODE))], **alone)
    assert "SET_POSITION" in faults(PILOT, [*flown, sent(120, velocity(0))], **alone)
    silent = [one for one in flown if one.up or one.at < 120]
    assert "no heartbeat" in faults(PILOT, silent, **alone)
    assert not faults(PILOT, silent, **alone, server_away=(119.5, 140.5))


def test_commands_from_before_a_standstill_are_a_fault() -> None:
    """Of the judge alone: a place that was commanded before is told from another one."""
    there = mavlink.MAVLink_command_int_message(7, 1, 3, 192, 0, 0, 0, 0, 0, 0, 473_000_000, 85_000_000, 30)
    commanded = [(473_000_000, 85_000_000)]
    stood = {"server_away": (LEFT, 120.0), "stood_still": True, "expired_targets": commanded}
    home = flight((95, 126, GUIDED, 0), (126, 140, RTL, 3))
    guided = replace(STEERED, kind="mission", event="standstill")
    assert not faults(guided, [*home, sent(99, there)], **stood)
    assert "commanded before it" in faults(guided, [*home, sent(99, there), sent(121, there)], **stood)
    assert "never said" in faults(guided, home, **stood)
