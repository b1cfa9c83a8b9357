package org.dronemap.sim;

import java.util.Locale;

/**
 * The recorded exchanges: at which height above home each began, and what had been done before, such as parameters set
 * (NAME=VALUE).
 */
enum RecordedExchange {
    ARMING_REFUSED(0, "power-up"),
    MODES_REFUSED(0, "power-up"),
    MODES_REFUSED_ARMED(0, "without GPS and checks"),
    GPS_MISSING_ON_GROUND(0, "without GPS"),
    MESSAGES_ASKED_FOR(0, ""),
    COMMANDS_ODD(0, ""),
    COMMANDS_TWICE(0, "guided"),
    ARM_AND_DISARM(0, ""),
    ARMING_BY_MODE(0, ""),
    TAKEOFF_REFUSED(0, ""),
    GUIDED_TAKEOFF(0, ""),
    MISSION_UPLOAD(0, ""),
    MISSION_UPLOAD_REFUSED(0, ""),
    MISSION_FLIGHT(0, "six items"),
    MISSION_FROM_THE_AIR(20, "five items"),
    MISSION_CLEARED_IN_FLIGHT(20, "in AUTO"),
    HOLD_IN_FLIGHT(30, ""),
    SPEED_AND_HOME(20, ""),
    GO_TO_BY_SETPOINT(20, ""),
    LED_BY_PLACES(20, ""),
    GO_TO_BY_REPOSITION(20, ""),
    DISARM_IN_FLIGHT(20, ""),
    MODES_REFUSED_IN_FLIGHT(20, ""),
    RTL_FROM_20_M(20, ""),
    RTL_FROM_8_M(8, ""),
    RTL_CLOSE_TO_HOME(8, ""),
    BATTERY_LOW(20, "battery"),
    BATTERY_CRITICAL(20, "battery"),
    BATTERY_LOW_BY_DEFAULT(20, ""),
    GPS_LOST(20, ""),
    GROUND_STATION_LOST(20, "ground station"),
    GROUND_STATION_LOST_BY_DEFAULT(20, ""),
    GROUND_STATION_LOST_IN_AUTO(20, "in AUTO, ground station"),
    MOTOR_FAILURE(30, ""),
    ROVER_ARMING_BY_MODE(0, ""),
    ROVER_ARMING_REFUSED(0, "power-up"),
    ROVER_BATTERY_LOW(0, "BATT_LOW_VOLT=11.5 BATT_FS_LOW_ACT=1 BATT_CRT_VOLT=10.5 BATT_FS_CRT_ACT=2"),
    ROVER_COMMANDS_REFUSED(0, ""),
    ROVER_GO_TO_BY_REPOSITION(0, ""),
    ROVER_GO_TO_BY_SETPOINT(0, ""),
    ROVER_GPS_LOST(0, ""),
    ROVER_GROUND_STATION_LOST(0, "ground station"),
    ROVER_GROUND_STATION_LOST_IN_AUTO(0, "FS_GCS_ENABLE=2"),
    ROVER_GROUND_STATION_LOST_RETURNS(0, "FS_GCS_ENABLE=1 FS_ACTION=1"),
    ROVER_GROUND_STATION_LOST_STANDING(0, "FS_GCS_ENABLE=1 FS_ACTION=1"),
    ROVER_HOLD_WHILE_DRIVING(0, ""),
    ROVER_MISSION_DRIVE(0, ""),
    ROVER_MISSION_OF_AIRCRAFT(0, ""),
    ROVER_MISSION_PAUSED(0, ""),
    ROVER_MISSION_UPLOAD(0, ""),
    ROVER_MODES_REFUSED(0, ""),
    ROVER_MODES_REFUSED_WITHOUT_POSITION(0, "never a position"),
    ROVER_RETURN_HOME(0, ""),
    PLANE_ARMING_REFUSED(0, "power-up"),
    PLANE_MODES_ON_GROUND(0, ""),
    PLANE_COMMANDS_ON_GROUND(0, ""),
    PLANE_COMMANDS_IN_FLIGHT(0, ""),
    PLANE_MISSION_UPLOAD(0, ""),
    PLANE_TAKEOFF_MODE(0, ""),
    PLANE_GUIDED(0, ""),
    PLANE_SPEED(0, ""),
    PLANE_MISSION_FLIGHT(0, "RTL_AUTOLAND=3"),
    PLANE_MISSION_NOT_ARMABLE(0, ""),
    PLANE_MISSION_TO_RTL(0, ""),
    PLANE_MISSION_TO_ITS_END(0, ""),
    PLANE_LOITER_ITEMS(0, ""),
    PLANE_GO_AROUND(0, "RTL_AUTOLAND=3"),
    PLANE_LAND_START(0, "RTL_AUTOLAND=3"),
    PLANE_LAND_NOWHERE(0, ""),
    PLANE_RTL_LANDS(0, "RTL_AUTOLAND=1"),
    PLANE_GROUND_STATION_LOST(0, "FS_GCS_ENABL=1 FS_LONG_ACTN=1"),
    PLANE_GROUND_STATION_LOST_BY_DEFAULT(0, ""),
    PLANE_GROUND_STATION_LOST_IN_AUTO(0, "FS_GCS_ENABL=1 RTL_AUTOLAND=3"),
    PLANE_BATTERY_LOW(0, "BATT_LOW_VOLT=11.5 BATT_FS_LOW_ACT=1"),
    QUADPLANE_MODES_ON_GROUND(0, ""),
    QUADPLANE_GUIDED_TAKEOFF(0, ""),
    QUADPLANE_GUIDED_FLIGHT(0, ""),
    QUADPLANE_HOVER_MODES(0, ""),
    QUADPLANE_MISSION_FLIGHT(0, ""),
    QUADPLANE_RTL(0, ""),
    QUADPLANE_RTL_LANDS(0, "Q_RTL_MODE=1"),
    QUADPLANE_GROUND_STATION_LOST(0, "FS_GCS_ENABL=1 FS_LONG_ACTN=1");

    final double height;
    final String preparation;

    RecordedExchange(double height, String preparation) {
        this.height = height;
        this.preparation = preparation;
    }

    String fileName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
