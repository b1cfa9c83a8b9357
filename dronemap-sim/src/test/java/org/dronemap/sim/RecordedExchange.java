package org.dronemap.sim;

import java.util.Locale;

/** The recorded exchanges: at which height above home each began, and what had been done before. */
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
    READINESS_BY_MODE(0, "power-up"),
    GPS_BACK_ON_GROUND(0, "guided"),
    GPS_GAP_IN_FLIGHT(20, ""),
    MODES_WITHOUT_GPS_IN_FLIGHT(20, ""),
    ARM_AFTER_MISSION(0, "after a mission"),
    ARM_AFTER_RTL(0, "after a return"),
    MISSION_WITH_TASKS(0, ""),
    MISSION_REFUSED_FOR_ONE_ITEM(0, ""),
    SPEED_IN_AUTO(20, "150 m north"),
    FENCE_UPLOAD(0, ""),
    FENCE_SWITCHED(0, ""),
    FENCE_ARMING_OUTSIDE(0, ""),
    FENCE_TARGETS_OUTSIDE(20, "fence"),
    FENCE_BREACHED_IN_AUTO(20, "fence, 150 m north"),
    FENCE_BREACHED_IN_HEIGHT(0, "fence"),
    FENCE_BREACH_ONLY_TOLD(20, "fence that tells, 75 m north"),
    TWO_BATTERIES(0, "two batteries"),
    SECOND_BATTERY_LOW(20, "two batteries"),
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
    ROVER_BATTERY_LOW(0, "battery, rover"),
    ROVER_COMMANDS_REFUSED(0, ""),
    ROVER_GO_TO_BY_REPOSITION(0, ""),
    ROVER_GO_TO_BY_SETPOINT(0, ""),
    ROVER_GPS_LOST(0, ""),
    ROVER_GROUND_STATION_LOST(0, "ground station"),
    ROVER_GROUND_STATION_LOST_IN_AUTO(0, "ground station, rover goes on"),
    ROVER_GROUND_STATION_LOST_RETURNS(0, "ground station, rover returns"),
    ROVER_GROUND_STATION_LOST_STANDING(0, "ground station, rover returns"),
    ROVER_HOLD_WHILE_DRIVING(0, ""),
    ROVER_MISSION_DRIVE(0, ""),
    ROVER_MISSION_OF_AIRCRAFT(0, ""),
    ROVER_MISSION_PAUSED(0, ""),
    ROVER_MISSION_UPLOAD(0, ""),
    ROVER_MODES_REFUSED(0, ""),
    ROVER_MODES_REFUSED_WITHOUT_POSITION(0, "never a position"),
    ROVER_RETURN_HOME(0, "");

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
