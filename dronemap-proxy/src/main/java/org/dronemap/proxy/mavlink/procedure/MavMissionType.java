package org.dronemap.proxy.mavlink.procedure;

/** MAV_MISSION_TYPE: whether a list of items on a vehicle is its mission, its fence or its rally points. */
public enum MavMissionType {
    MISSION(0),
    FENCE(1),
    RALLY(2);

    private final int number;

    MavMissionType(int number) {
        this.number = number;
    }

    public int number() {
        return number;
    }
}
