"""Exchanges with ArduRover. Each begins where the vehicle stands, in MANUAL, unless it says "from power-up"."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from exchange import Exchange
from flying import ACCEPTED, GLOBAL_RELATIVE, arm, go_to, north_of_here, ready, start
from missions import Item, clear, download, upload
from vehicle_link import VehicleLink

WAYPOINT = int(mavlink.MAV_CMD_NAV_WAYPOINT)
DEGREES_E7_PER_METER_NORTH = 1e7 / 111_319.5
MODES = ("MANUAL", "ACRO", "STEERING", "HOLD", "LOITER", "GUIDED", "RTL", "SMART_RTL")


def ready_to_drive(link: VehicleLink, mode: str = "GUIDED") -> None:
    """Ready, the exchange begins, the mode is chosen, armed."""
    ready(link)
    start(link)
    link.set_mode_and_acknowledge(mode)
    link.wait_until(mode, lambda: link.mode == mode, 5)
    arm(link)
    link.pump_for(2)


def stopped(link: VehicleLink, seconds: float = 60) -> None:
    """Wait until it has set off and stands again."""
    link.wait_until("set off", lambda: speed(link) > 0.5, 10)
    link.wait_until("stopped", lambda: speed(link) < 0.1, seconds)
    link.pump_for(3)


def speed(link: VehicleLink) -> float:
    """Metres a second over ground."""
    return float(link.last["VFR_HUD"].groundspeed)


def drive(home: tuple[int, int]) -> list[Item]:
    """Five items: home, then three waypoints 25 m apart, at the second of which it waits for 3 s, and one at home."""
    latitude, longitude = home
    north = round(25 * DEGREES_E7_PER_METER_NORTH)
    east = round(north * 1.226)  # at the recording's latitude of 35.4 degrees
    return [
        Item(WAYPOINT, latitude, longitude, 0),
        Item(WAYPOINT, latitude + north, longitude, 0),
        Item(WAYPOINT, latitude + north, longitude + east, 0, param1=3),
        Item(WAYPOINT, latitude, longitude + east, 0),
        Item(WAYPOINT, latitude, longitude, 0),
    ]


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


def mission_upload(link: VehicleLink) -> None:
    """Items of aircraft, items that it does not know, hold seconds with a fraction, read back, cleared."""
    ready(link)
    start(link)
    items = drive(link.position)
    latitude, longitude = link.position
    aircraft = (
        Item(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 10),
        Item(mavlink.MAV_CMD_NAV_LAND, latitude, longitude, 0),
        Item(mavlink.MAV_CMD_NAV_LOITER_TIME, latitude, longitude, 0, param1=2),
        Item(mavlink.MAV_CMD_NAV_DELAY, 0, 0, 0, param1=2),
        Item(mavlink.MAV_CMD_DO_CHANGE_SPEED, 0, 0, 0, param1=1, param2=2),
        Item(mavlink.MAV_CMD_CONDITION_YAW, 0, 0, 0, param1=90),
        Item(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0, 0),
    )
    upload(link, [*items[:2], *aircraft])
    download(link)
    upload(link, [*items[:2], Item(WAYPOINT, latitude, longitude, 0, param1=2.5)])
    download(link)
    for unknown in (mavlink.MAV_CMD_NAV_LOITER_TO_ALT, mavlink.MAV_CMD_NAV_SPLINE_WAYPOINT, 31000):
        upload(link, [*items[:2], Item(unknown, latitude, longitude, 0), *items[3:]])
        link.pump_for(0.5)
    download(link)
    clear(link)
    download(link)


def mission_drive(link: VehicleLink) -> None:
    """AUTO by MISSION_START from HOLD: waypoints, a wait of 3 s, complete; then MISSION_START and AUTO once more."""
    ready(link)
    start(link)
    upload(link, drive(link.position))
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(1)
    arm(link)
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    complete(link)
    link.pump_for(5)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.pump_for(3)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.pump_for(8)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def complete(link: VehicleLink, seconds: float = 120) -> None:
    """Wait for the sentence that ends a mission."""
    link.expect(
        "Mission Complete", lambda m: m.get_type() == "STATUSTEXT" and m.text.startswith("Mission Complete"), seconds
    )


def mission_of_aircraft(link: VehicleLink) -> None:
    """A take-off, a change of speed, a waypoint, a landing, a delay, a turn and a return, driven."""
    ready(link)
    start(link)
    link.pump_for(1)
    items = drive(link.position)
    latitude, longitude = link.position
    upload(
        link,
        [
            items[0],
            Item(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 10),
            Item(mavlink.MAV_CMD_DO_CHANGE_SPEED, 0, 0, 0, param1=1, param2=3),
            items[1],
            Item(mavlink.MAV_CMD_NAV_LAND, latitude, longitude, 0),
            Item(mavlink.MAV_CMD_NAV_DELAY, 0, 0, 0, param1=2),
            Item(mavlink.MAV_CMD_NAV_LOITER_TIME, items[1].latitude, items[1].longitude, 0, param1=2),
            Item(mavlink.MAV_CMD_CONDITION_YAW, 0, 0, 0, param1=90),
            Item(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH, 0, 0, 0),
        ],
    )
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    complete(link)
    link.pump_for(5)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def mission_paused(link: VehicleLink) -> None:
    """HOLD and AUTO again, the pause that it does not know, another item, clearing while it drives."""
    ready(link)
    start(link)
    link.pump_for(1)
    upload(link, drive(link.position))
    link.set_mode_and_acknowledge("HOLD")
    arm(link)
    link.pump_for(1)
    link.set_mode_and_acknowledge("AUTO")
    link.wait_until("item 2", lambda: link.last["MISSION_CURRENT"].seq == 2, 30)
    link.pump_for(2)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(6)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.pump_for(1)
    link.send(mavlink.MAVLink_mission_set_current_message(link.system_id, 1, 4))
    link.pump_for(3)
    clear(link)
    link.pump_for(2)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MISSION_CURRENT, 2)
    link.pump_for(2)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(4)
    link.set_mode_and_acknowledge("HOLD")
    link.pump_for(3)


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
    Exchange("rover_mission_upload", "items of aircraft, unknown items, hold seconds, read back", mission_upload),
    Exchange("rover_mission_drive", "a mission to its end, started twice", mission_drive),
    Exchange("rover_mission_of_aircraft", "a mission with take-off, landing, delay and return", mission_of_aircraft),
    Exchange("rover_mission_paused", "HOLD and AUTO, another item, clearing while it drives", mission_paused),
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
