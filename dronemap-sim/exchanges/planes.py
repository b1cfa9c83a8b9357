"""The fixed lists of exchanges with ArduPlane, one without and one with lift motors (a QuadPlane)."""

from __future__ import annotations

import landed_plane_exchanges as landed
import plane_exchanges as plane
import quadplane_exchanges as quadplane
from exchange import Exchange

GROUND_STATION = {"FS_GCS_ENABL": 1, "FS_LONG_ACTN": 1}
# With the default a DO_LAND_START in the mission keeps it from arming.
GO_AROUND_ONLY = {"RTL_AUTOLAND": 3}

PLANE_EXCHANGES: tuple[Exchange, ...] = (
    Exchange("plane_arming_refused", "from power-up until arming is granted", plane.arming_refused, from_power_up=True),
    Exchange("plane_modes_on_ground", "each mode on the ground, and arming in it", plane.modes_on_ground),
    Exchange("plane_commands_on_ground", "take-off, landing, go-to and others, refused", plane.commands_on_ground),
    Exchange("plane_commands_in_flight", "the same in LOITER and GUIDED", plane.commands_in_flight),
    Exchange("plane_mission_upload", "what is kept of items, and which are refused", plane.mission_upload),
    Exchange("plane_takeoff_mode", "TAKEOFF, LOITER, RTL", plane.takeoff_mode),
    Exchange("plane_guided", "DO_REPOSITION, circling there, a height alone", plane.guided),
    Exchange("plane_speed", "DO_CHANGE_SPEED in GUIDED", plane.speed),
    Exchange("plane_mission_flight", "take-off, waypoints, DO_LAND_START, LAND", plane.mission_flight, GO_AROUND_ONLY),
    Exchange("plane_mission_not_armable", "DO_LAND_START with RTL_AUTOLAND 0", plane.mission_not_armable),
    Exchange("plane_mission_to_rtl", "a mission that ends with RTL", plane.mission_to_rtl),
    Exchange("plane_mission_to_its_end", "a mission whose last item is a waypoint", plane.mission_to_its_end),
    Exchange("plane_loiter_items", "loiter by time, turns, to a height, for ever", plane.loiter_items),
    Exchange("plane_go_around", "DO_GO_AROUND on the approach", plane.go_around, GO_AROUND_ONLY),
    Exchange("plane_land_start", "DO_LAND_START as a command", plane.land_start, GO_AROUND_ONLY),
    Exchange("plane_land_nowhere", "LAND with the place 0/0", plane.land_nowhere),
    Exchange("plane_landed", "arming after a landing by mission", landed.landed_by_mission),
    Exchange("plane_landed_cleared", "the same with its mission cleared", landed.landed_and_cleared),
    Exchange("plane_landed_manual", "the same, and a mode that a pilot flies", landed.landed_and_manual),
    Exchange("plane_rtl_lands", "RTL that goes over to the mission's landing", plane.rtl_lands, {"RTL_AUTOLAND": 1}),
    Exchange(
        "plane_ground_station_lost",
        "heartbeats stop in GUIDED, told to return",
        plane.ground_station_lost,
        GROUND_STATION,
        log_heartbeats=True,
    ),
    Exchange(
        "plane_ground_station_lost_by_default",
        "heartbeats stop, default",
        plane.ground_station_lost_by_default,
        log_heartbeats=True,
    ),
    Exchange(
        "plane_ground_station_lost_in_auto",
        "heartbeats stop in AUTO, told to continue",
        plane.ground_station_lost_in_auto,
        {"FS_GCS_ENABL": 1, **GO_AROUND_ONLY},
        log_heartbeats=True,
    ),
    Exchange(
        "plane_battery_low",
        "low battery with RTL as action",
        plane.battery_low,
        {"BATT_LOW_VOLT": 11.5, "BATT_FS_LOW_ACT": 1},
    ),
)

QUADPLANE_EXCHANGES: tuple[Exchange, ...] = (
    Exchange("quadplane_modes_on_ground", "modes of the lift motors, and arming in them", quadplane.modes_on_ground),
    Exchange("quadplane_guided_takeoff", "NAV_TAKEOFF in GUIDED, QLAND", quadplane.guided_takeoff),
    Exchange("quadplane_guided_flight", "from a hover to its wings, and QRTL", quadplane.guided_flight),
    Exchange("quadplane_hover_modes", "QLOITER without a pilot, GUIDED, QLAND", quadplane.hover_modes),
    Exchange("quadplane_mission_flight", "VTOL take-off, waypoints, VTOL landing", quadplane.mission_flight),
    Exchange("quadplane_rtl", "RTL in a hover: it circles on its wings", quadplane.rtl),
    Exchange("quadplane_rtl_lands", "RTL that goes over to QRTL at home", quadplane.rtl_lands, {"Q_RTL_MODE": 1}),
    Exchange(
        "quadplane_ground_station_lost",
        "heartbeats stop in a hover, told to return",
        quadplane.ground_station_lost,
        GROUND_STATION,
        log_heartbeats=True,
    ),
)
