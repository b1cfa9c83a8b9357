"""The fixed list of exchanges with ArduCopter: each takes one freshly started vehicle through one thing.

An exchange prepares (`ready`, `airborne` …), calls `start`, and from there on every line of its file is written.
"""

from __future__ import annotations

from exchange import Exchange
from fault_exchanges import (
    battery_critical,
    battery_low,
    battery_low_by_default,
    gps_lost,
    gps_missing_on_ground,
    ground_station_lost,
    ground_station_lost_by_default,
    ground_station_lost_in_auto,
    motor_failure,
)
from flight_exchanges import (
    commands_twice,
    disarm_in_flight,
    follow_moving_setpoint,
    go_to_by_reposition,
    go_to_by_setpoint,
    guided_takeoff,
    hold_in_flight,
    rtl_close_to_home,
    rtl_from_8_m,
    rtl_from_20_m,
    speed_and_home,
)
from ground_exchanges import (
    arm_and_disarm,
    arming_by_mode,
    arming_refused,
    commands_odd,
    messages_asked_for,
    modes_refused,
    modes_refused_armed,
    modes_refused_in_flight,
    takeoff_refused,
)
from mission_exchanges import (
    mission_cleared_in_flight,
    mission_flight,
    mission_from_the_air,
    mission_upload,
    mission_upload_refused,
)

RTL_ON_LOW = {"BATT_LOW_VOLT": 11.5, "BATT_FS_LOW_ACT": 2, "BATT_CRT_VOLT": 10.5, "BATT_FS_CRT_ACT": 1}
MOTOR = {"SIM_ENGINE_FAIL": 0}

EXCHANGES: tuple[Exchange, ...] = (
    Exchange("arming_refused", "from power-up until arming is granted", arming_refused, from_power_up=True),
    Exchange("modes_refused", "modes without position, unknown, without mission", modes_refused),
    Exchange(
        "modes_refused_armed",
        "modes that need a position, armed without one",
        modes_refused_armed,
        {"SIM_GPS_DISABLE": 1, "ARMING_CHECK": 0},
    ),
    Exchange("modes_refused_in_flight", "AUTO without mission and others, in flight", modes_refused_in_flight),
    Exchange("arm_and_disarm", "arming, disarming, disarming by itself on the ground", arm_and_disarm),
    Exchange("arming_by_mode", "in which modes it arms", arming_by_mode),
    Exchange("takeoff_refused", "take-off not armed, in other modes, to bad heights", takeoff_refused),
    Exchange("guided_takeoff", "take-off to 20 m in GUIDED, landing, disarming", guided_takeoff),
    Exchange("commands_odd", "unknown commands, other targets, wrong form", commands_odd),
    Exchange("commands_twice", "second copies of commands are acted on again", commands_twice),
    Exchange("messages_asked_for", "rates and single messages", messages_asked_for),
    Exchange("mission_upload", "upload, read back, overwrite, clear", mission_upload),
    Exchange("mission_upload_refused", "bad items and an upload that is given up", mission_upload_refused),
    Exchange("mission_flight", "a six-item mission from the ground to disarmed", mission_flight),
    Exchange("mission_from_the_air", "AUTO in flight, pause, jump, last item a waypoint", mission_from_the_air),
    Exchange("mission_cleared_in_flight", "clearing the mission that is flown", mission_cleared_in_flight),
    Exchange("go_to_by_setpoint", "SET_POSITION_TARGET_GLOBAL_INT, 150 m", go_to_by_setpoint),
    Exchange("led_by_places", "a place that moves, ten times a second, then silence", follow_moving_setpoint),
    Exchange("go_to_by_reposition", "COMMAND_INT DO_REPOSITION", go_to_by_reposition),
    Exchange("hold_in_flight", "stopping in flight: pause, BRAKE, LOITER", hold_in_flight),
    Exchange("speed_and_home", "DO_CHANGE_SPEED twice, DO_SET_HOME", speed_and_home),
    Exchange("rtl_from_20_m", "RTL from above RTL_ALT", rtl_from_20_m),
    Exchange("rtl_from_8_m", "RTL from below RTL_ALT", rtl_from_8_m),
    Exchange("rtl_close_to_home", "RTL above home", rtl_close_to_home),
    Exchange("disarm_in_flight", "refused, then forced", disarm_in_flight),
    Exchange("battery_low", "low battery with RTL as action", battery_low, RTL_ON_LOW),
    Exchange("battery_critical", "critical battery with LAND as action", battery_critical, RTL_ON_LOW),
    Exchange("battery_low_by_default", "low battery, default action", battery_low_by_default),
    Exchange(
        "ground_station_lost",
        "heartbeats stop, FS_GCS_ENABLE 1",
        ground_station_lost,
        {"FS_GCS_ENABLE": 1},
        log_heartbeats=True,
    ),
    Exchange(
        "ground_station_lost_by_default",
        "heartbeats stop, default",
        ground_station_lost_by_default,
        log_heartbeats=True,
    ),
    Exchange(
        "ground_station_lost_in_auto",
        "heartbeats stop in AUTO, told to continue",
        ground_station_lost_in_auto,
        {"FS_GCS_ENABLE": 1, "FS_OPTIONS": 2},
        log_heartbeats=True,
    ),
    Exchange("motor_failure", "one motor stops at 30 m", motor_failure, MOTOR),
    Exchange("gps_lost", "GPS gone in flight", gps_lost),
    Exchange("gps_missing_on_ground", "GPS gone before arming", gps_missing_on_ground),
)
