"""Exchanges with ArduRover. Each begins where the vehicle stands, in MANUAL, unless it says "from power-up"."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

import rover_missions as missions
from exchange import Exchange
from flying import ACCEPTED, GLOBAL_RELATIVE, arm, go_to, north_of_here, ready, start
from missions import upload
from rover_driving import drive, ready_to_drive, stopped
from vehicle_link import VehicleLink

MODES = ("MANUAL", "ACRO", "STEERING", "HOLD", "LOITER", "GUIDED", "RTL", "SMART_RTL")


def arming_refused(link: VehicleLink) -> None:
    """From power-up: arm in MANUAL is asked for once it is ready, then arm in GUIDED every 5 s until it is granted."""
    start(link)
    link.request_rates()
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1)
    link.set_mode_and_acknowledge("GUIDED")
    for _ in range(20):
        if link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == ACCEPTED:
            break
        link.pump_for(5)
    link.pump_for(3)


def arming_by_mode(link: VehicleLink) -> None:
    """Each mode disarmed, arming in it, arming again, disarming."""
    ready(link)
    start(link)
    for name in MODES:
        link.set_mode_and_acknowledge(name)
        link.pump_for(1)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1)
        link.pump_for(1.5)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        link.pump_for(1.5)


def modes_refused(link: VehicleLink) -> None:
    """AUTO without a mission, unknown modes, disarmed and armed; SET_MODE; armed for 15 s without moving."""
    ready(link)
    start(link)
    for armed in (False, True):
        if armed:
            link.set_mode_and_acknowledge("HOLD")
            arm(link)
        for name in ("AUTO", "GUIDED", "SMART_RTL", "RTL"):
            link.set_mode_and_acknowledge(name)
            link.pump_for(1.5)
        for number in (2, 99):
            link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, number)
            link.pump_for(0.5)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, 0, 4)
        link.send(mavlink.MAVLink_set_mode_message(link.system_id, 1, 4))
        link.pump_for(1)
        link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
        link.pump_for(1)
    link.pump_for(15)


def modes_refused_without_position(link: VehicleLink) -> None:
    """Armed in MANUAL with no GPS: modes that need a position."""
    link.wait_until("attitude", lambda: "EKF_STATUS_REPORT" in link.last, 10)
    link.pump_for(20)
    start(link)
    for _ in range(6):
        if arm(link) == ACCEPTED:
            break
        link.pump_for(4)
    for name in ("GUIDED", "LOITER", "RTL", "AUTO", "STEERING", "HOLD"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(0.5)
    link.pump_for(2)


def commands_refused(link: VehicleLink) -> None:
    """Armed in GUIDED: what only aircraft do, what needs another form, and what it takes."""
    ready_to_drive(link)
    long_commands: tuple[tuple[int, tuple[float, ...]], ...] = (
        (mavlink.MAV_CMD_NAV_TAKEOFF, (0, 0, 0, 0, 0, 0, 10)),
        (mavlink.MAV_CMD_NAV_LAND, ()),
        (mavlink.MAV_CMD_NAV_LOITER_UNLIM, ()),
        (mavlink.MAV_CMD_DO_LAND_START, ()),
        (mavlink.MAV_CMD_DO_GO_AROUND, ()),
        (mavlink.MAV_CMD_CONDITION_YAW, (90, 20, 1, 0)),
        (mavlink.MAV_CMD_DO_PAUSE_CONTINUE, (0,)),
        (mavlink.MAV_CMD_DO_PAUSE_CONTINUE, (1,)),
        (mavlink.MAV_CMD_DO_REPOSITION, (-1, 1, 0, 0, -35.3632, 149.1653, 0)),
        (mavlink.MAV_CMD_DO_CHANGE_ALTITUDE, (10, 3)),
        (mavlink.MAV_CMD_DO_CHANGE_SPEED, (1, 2, -1)),
        (mavlink.MAV_CMD_DO_CHANGE_SPEED, (1, -2, -1)),
        (mavlink.MAV_CMD_DO_CHANGE_SPEED, (1, 0, -1)),
        (mavlink.MAV_CMD_DO_SET_REVERSE, (0,)),
        (mavlink.MAV_CMD_DO_ORBIT, (10, 2)),
        (mavlink.MAV_CMD_DO_SET_MISSION_CURRENT, (3,)),
        (31000, ()),
    )
    for command, params in long_commands:
        link.send_and_acknowledge(command, *params)
        link.pump_for(0.3)
    for place in ((950_000_000, 1_491_652_300, 0), (0, 0, 0)):
        link.command_int(mavlink.MAV_CMD_DO_REPOSITION, GLOBAL_RELATIVE, (-1, 0, 0, 0), place)
        link.wait_for_acknowledgement(mavlink.MAV_CMD_DO_REPOSITION)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(1)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, 1, 2, -1)
    place = (*north_of_here(link, 20), 0)
    link.command_int(mavlink.MAV_CMD_DO_REPOSITION, GLOBAL_RELATIVE, (-1, 0, 0, 0), place)
    link.wait_for_acknowledgement(mavlink.MAV_CMD_DO_REPOSITION)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(1.5)


def go_to_by_setpoint(link: VehicleLink) -> None:
    """SET_POSITION_TARGET_GLOBAL_INT in HOLD (not heeded) and in GUIDED: 60 m, then back on the way."""
    ready_to_drive(link, "HOLD")
    target = north_of_here(link, 60)
    home = link.position
    go_to(link, target, 0)
    link.pump_for(3)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(1)
    go_to(link, target, 0)
    stopped(link)
    go_to(link, home, 0)
    link.pump_for(5)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(8)


def go_to_by_reposition(link: VehicleLink) -> None:
    """COMMAND_INT DO_REPOSITION that changes the mode; slower; on the way disarmed."""
    ready_to_drive(link, "HOLD")
    place = (*north_of_here(link, 40), 10)
    link.command_int(mavlink.MAV_CMD_DO_REPOSITION, GLOBAL_RELATIVE, (-1, 1, 0, 0), place)
    link.wait_for_acknowledgement(mavlink.MAV_CMD_DO_REPOSITION)
    stopped(link)
    back = (*north_of_here(link, -40), 0)
    link.command_int(mavlink.MAV_CMD_DO_REPOSITION, GLOBAL_RELATIVE, (2, 1, 0, 0), back)
    link.wait_for_acknowledgement(mavlink.MAV_CMD_DO_REPOSITION)
    link.pump_for(8)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, 1, 3, -1)
    link.pump_for(5)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(4)


def hold_while_driving(link: VehicleLink) -> None:
    """On the way in GUIDED: LOITER, GUIDED again (it stands), a go-to, HOLD."""
    ready_to_drive(link)
    target = north_of_here(link, 120)
    for stopping in ("LOITER", "HOLD"):
        go_to(link, target, 0)
        link.pump_for(6)
        link.set_mode_and_acknowledge(stopping)
        link.pump_for(8)
        link.set_mode_and_acknowledge("GUIDED")
        link.pump_for(3)


def return_home(link: VehicleLink) -> None:
    """60 m away, RTL by command, at home it stands in RTL and stays armed; RTL again; from 30 m away by mode."""
    ready_to_drive(link)
    go_to(link, north_of_here(link, 60), 0)
    stopped(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    stopped(link)
    link.pump_for(12)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(1)
    go_to(link, north_of_here(link, 30), 0)
    stopped(link)
    link.set_mode_and_acknowledge("RTL")
    stopped(link)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def ground_station_lost(link: VehicleLink) -> None:
    """Heartbeats stop for 15 s on the way in GUIDED."""
    ready_to_drive(link)
    go_to(link, north_of_here(link, 200), 0)
    link.pump_for(4)
    link.heartbeats_on = False
    link.pump_for(15)
    link.heartbeats_on = True
    link.pump_for(5)


def ground_station_lost_in_auto(link: VehicleLink) -> None:
    """Heartbeats stop for 12 s while it drives a mission."""
    ready(link)
    start(link)
    upload(link, drive(link.position))
    link.set_mode_and_acknowledge("HOLD")
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(2)
    link.heartbeats_on = False
    link.pump_for(12)
    link.heartbeats_on = True
    link.pump_for(5)


def ground_station_lost_standing(link: VehicleLink) -> None:
    """Heartbeats stop for 12 s in HOLD, armed."""
    ready_to_drive(link, "HOLD")
    link.heartbeats_on = False
    link.pump_for(12)
    link.heartbeats_on = True
    link.pump_for(5)


def battery_low(link: VehicleLink) -> None:
    """The voltage falls under BATT_LOW_VOLT, then under BATT_CRT_VOLT, on the way in GUIDED."""
    ready_to_drive(link)
    go_to(link, north_of_here(link, 150), 0)
    link.pump_for(4)
    link.set_parameter("SIM_BATT_VOLTAGE", 11)
    link.pump_for(20)
    link.set_parameter("SIM_BATT_VOLTAGE", 10)
    link.pump_for(15)


def gps_lost(link: VehicleLink) -> None:
    """GPS gone while it drives in GUIDED, and back after 25 s."""
    ready_to_drive(link)
    go_to(link, north_of_here(link, 200), 0)
    link.pump_for(4)
    link.set_parameter("SIM_GPS_DISABLE", 1)
    link.pump_for(25)
    link.set_parameter("SIM_GPS_DISABLE", 0)
    link.pump_for(10)


RETURN_ON_LOW = {"BATT_LOW_VOLT": 11.5, "BATT_FS_LOW_ACT": 1, "BATT_CRT_VOLT": 10.5, "BATT_FS_CRT_ACT": 2}

ROVER_EXCHANGES: tuple[Exchange, ...] = (
    Exchange("rover_arming_refused", "from power-up until arming is granted", arming_refused, from_power_up=True),
    Exchange("rover_arming_by_mode", "in which modes it arms", arming_by_mode),
    Exchange("rover_modes_refused", "AUTO without a mission, unknown modes, disarmed and armed", modes_refused),
    Exchange(
        "rover_modes_refused_without_position",
        "modes that need a position, armed without one",
        modes_refused_without_position,
        {"SIM_GPS_DISABLE": 1, "ARMING_CHECK": 0},
    ),
    Exchange("rover_commands_refused", "take-off, landing and others; what it takes", commands_refused),
    Exchange(
        "rover_mission_upload", "items of aircraft, unknown items, hold seconds, read back", missions.mission_upload
    ),
    Exchange("rover_mission_drive", "a mission to its end, started twice", missions.mission_drive),
    Exchange(
        "rover_mission_of_aircraft", "a mission with take-off, landing, delay and return", missions.mission_of_aircraft
    ),
    Exchange("rover_mission_paused", "HOLD and AUTO, another item, clearing while it drives", missions.mission_paused),
    Exchange("rover_go_to_by_setpoint", "SET_POSITION_TARGET_GLOBAL_INT, 60 m", go_to_by_setpoint),
    Exchange(
        "rover_go_to_by_reposition", "COMMAND_INT DO_REPOSITION, speeds, disarmed on the way", go_to_by_reposition
    ),
    Exchange("rover_hold_while_driving", "stopping on the way: LOITER, HOLD", hold_while_driving),
    Exchange("rover_return_home", "RTL by command and by mode", return_home),
    Exchange(
        "rover_ground_station_lost",
        "heartbeats stop, FS_GCS_ENABLE 1, FS_ACTION 2 (hold, by default)",
        ground_station_lost,
        {"FS_GCS_ENABLE": 1},
        log_heartbeats=True,
    ),
    Exchange(
        "rover_ground_station_lost_returns",
        "heartbeats stop, FS_GCS_ENABLE 1, FS_ACTION 1 (RTL)",
        ground_station_lost,
        {"FS_GCS_ENABLE": 1, "FS_ACTION": 1},
        log_heartbeats=True,
    ),
    Exchange(
        "rover_ground_station_lost_in_auto",
        "heartbeats stop in AUTO, told to continue: holds all the same",
        ground_station_lost_in_auto,
        {"FS_GCS_ENABLE": 2},
        log_heartbeats=True,
    ),
    Exchange(
        "rover_ground_station_lost_standing",
        "heartbeats stop in HOLD",
        ground_station_lost_standing,
        {"FS_GCS_ENABLE": 1, "FS_ACTION": 1},
        log_heartbeats=True,
    ),
    Exchange("rover_battery_low", "low battery returns, critical holds", battery_low, RETURN_ON_LOW),
    Exchange("rover_gps_lost", "GPS gone on the way", gps_lost),
)
