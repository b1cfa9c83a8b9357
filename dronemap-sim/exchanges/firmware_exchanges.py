"""More exchanges with an ArduCopter: readiness, its fence, its batteries, missions with odd items."""

from __future__ import annotations

from battery_exchanges import second_battery_low, two_batteries
from exchange import Exchange
from fence_exchanges import (
    fence_arming_outside,
    fence_breach_only_told,
    fence_breached_in_auto,
    fence_breached_in_height,
    fence_switched,
    fence_targets_outside,
    fence_upload,
)
from odd_mission_exchanges import mission_refused_for_one_item, mission_with_tasks, speed_in_auto
from readiness_exchanges import (
    arm_after_mission,
    arm_after_rtl,
    gps_back_on_ground,
    gps_gap_in_flight,
    modes_without_gps_in_flight,
    readiness_by_mode,
)

FENCE = {"FENCE_ENABLE": 1, "FENCE_TYPE": 3, "FENCE_RADIUS": 60, "FENCE_ALT_MAX": 40, "AVOID_ENABLE": 0}
SECOND_BATTERY = {"BATT2_MONITOR": 4, "BATT2_VOLT_PIN": 13, "BATT2_CURR_PIN": 12, "BATT2_CAPACITY": 5000}

FIRMWARE_EXCHANGES: tuple[Exchange, ...] = (
    Exchange(
        "readiness_by_mode", "from power-up: arming by mode, health, estimate", readiness_by_mode, from_power_up=True
    ),
    Exchange("gps_back_on_ground", "GPS gone before arming, and back", gps_back_on_ground),
    Exchange("gps_gap_in_flight", "GPS gone for 4 s, twice", gps_gap_in_flight),
    Exchange("modes_without_gps_in_flight", "which modes are left when GPS is gone", modes_without_gps_in_flight),
    Exchange("arm_after_mission", "arming after a mission that ended with RTL", arm_after_mission),
    Exchange("arm_after_rtl", "arming after a return to launch", arm_after_rtl),
    Exchange("mission_with_tasks", "a mission with items that are not flown", mission_with_tasks),
    Exchange("mission_refused_for_one_item", "missions with one item that is unknown", mission_refused_for_one_item),
    Exchange("speed_in_auto", "DO_CHANGE_SPEED in AUTO", speed_in_auto),
    Exchange("fence_upload", "fences up, read back, refused, cleared", fence_upload),
    Exchange("fence_switched", "the fence switched on and off", fence_switched),
    Exchange("fence_arming_outside", "arming outside of a polygon", fence_arming_outside),
    Exchange("fence_targets_outside", "GUIDED targets outside", fence_targets_outside, FENCE),
    Exchange("fence_breached_in_auto", "AUTO leads out of the circle", fence_breached_in_auto, FENCE),
    Exchange("fence_breached_in_height", "a take-off above the height", fence_breached_in_height, FENCE),
    Exchange(
        "fence_breach_only_told", "a breach without an action", fence_breach_only_told, {**FENCE, "FENCE_ACTION": 0}
    ),
    Exchange("two_batteries", "BATTERY_STATUS of two", two_batteries, boot_parameters=SECOND_BATTERY),
    Exchange(
        "second_battery_low", "the second battery's fail-safe", second_battery_low, boot_parameters=SECOND_BATTERY
    ),
)
