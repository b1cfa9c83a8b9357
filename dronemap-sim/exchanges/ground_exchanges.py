"""Exchanges on the ground."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import ACCEPTED, GLOBAL_RELATIVE, airborne, arm, disarmed, ready, start, take_off
from vehicle_link import VehicleLink


def arming_refused(link: VehicleLink) -> None:
    """From power-up: arm and GUIDED asked every 5 s until both are granted."""
    start(link)
    link.request_rates()
    for _ in range(20):
        armed = link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == ACCEPTED
        guided = link.set_mode_and_acknowledge("GUIDED") == ACCEPTED
        if armed and guided:
            break
        link.pump_for(5)
    link.pump_for(3)


def modes_refused(link: VehicleLink) -> None:
    """Before the position estimate: modes that need one, an unknown one, the older SET_MODE; AUTO without a mission."""
    start(link)
    for name in ("LOITER", "RTL", "AUTO", "ALT_HOLD", "LAND", "STABILIZE"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1.5)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, 99)
    link.send(mavlink.MAVLink_set_mode_message(link.system_id, 1, 4))
    link.pump_for(2)
    ready(link)
    for name in ("AUTO", "LOITER", "GUIDED", "RTL", "BRAKE", "STABILIZE"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1.5)


def modes_refused_armed(link: VehicleLink) -> None:
    """Armed in STABILIZE with no GPS: modes that need a position."""
    link.wait_until("attitude", lambda: "EKF_STATUS_REPORT" in link.last, 10)
    link.pump_for(20)
    start(link)
    for _ in range(6):
        if arm(link) == ACCEPTED:
            break
        link.pump_for(4)
    for name in ("GUIDED", "LOITER", "RTL", "AUTO", "BRAKE"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(0.5)
    link.pump_for(2)


def modes_refused_in_flight(link: VehicleLink) -> None:
    """In flight: AUTO without a mission, an unknown mode, take-off from a mode that cannot, then a good one."""
    airborne(link)
    start(link)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, 99)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.pump_for(2)
    link.set_mode_and_acknowledge("BRAKE")
    link.pump_for(3)


def arm_and_disarm(link: VehicleLink) -> None:
    """Arm in GUIDED, disarm by command; arm again and wait for the disarming by itself."""
    ready(link)
    start(link)
    link.set_mode_and_acknowledge("GUIDED")
    link.wait_until("GUIDED", lambda: link.mode == "GUIDED", 5)
    arm(link)
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    disarmed(link)
    arm(link)
    disarmed(link)


def arming_by_mode(link: VehicleLink) -> None:
    """Arming asked for in each mode, on the ground."""
    ready(link)
    start(link)
    for name in ("LOITER", "ALT_HOLD", "STABILIZE", "RTL", "LAND", "AUTO", "BRAKE"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1)
        if arm(link) == ACCEPTED:
            link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        link.pump_for(2)


def takeoff_refused(link: VehicleLink) -> None:
    """Take-off not armed; armed in LOITER and STABILIZE; in GUIDED to 0 m, then below ground."""
    ready(link)
    start(link)
    link.set_mode_and_acknowledge("GUIDED")
    take_off(link, 20)
    link.pump_for(2)
    for name in ("STABILIZE", "LOITER"):
        link.set_mode_and_acknowledge(name)
        arm(link)
        take_off(link, 20)
        link.pump_for(2)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        link.pump_for(1)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    take_off(link, 0)
    take_off(link, -5)
    link.pump_for(3)


def commands_odd(link: VehicleLink) -> None:
    """Commands that nobody knows, for somebody else, or in the wrong form."""
    ready(link)
    start(link)
    link.send_and_acknowledge(31999)
    link.command_int(31999, GLOBAL_RELATIVE, (0, 0, 0, 0), (0, 0, 0))
    link.wait_for_acknowledgement(31999)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_REPOSITION, -1, 1, 0, 0, 0, 0, 20)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
    link.set_mode_and_acknowledge("STABILIZE")
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, 0, 4)
    link.command_long(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1, component=0)
    link.wait_for_acknowledgement(mavlink.MAV_CMD_COMPONENT_ARM_DISARM)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.command_long(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1, component=42)
    own, link.system_id = link.system_id, 77
    link.command_long(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1)
    link.system_id = own
    link.pump_for(3)


def messages_asked_for(link: VehicleLink) -> None:
    """SET_MESSAGE_INTERVAL and REQUEST_MESSAGE, known and unknown."""
    ready(link)
    start(link)
    position = mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT
    link.send_and_acknowledge(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, position, 250_000)
    link.send_and_acknowledge(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 60_000, 250_000)
    for message_id in (
        mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION,
        mavlink.MAVLINK_MSG_ID_HOME_POSITION,
        60_000,
    ):
        link.send_and_acknowledge(mavlink.MAV_CMD_REQUEST_MESSAGE, message_id)
    link.send_and_acknowledge(mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, 1)
    link.pump_for(2)
