package org.dronemap.proxy.mavlink.procedure;

/** MAV_MISSION_TYPE: whether a list of items on a vehicle is its mission, its fence or its rally points. */
public enum MavMissionType {
    MISSION(0, "mission"),
    FENCE(1, "fence"),
    RALLY(2, "rally points");

    private final int number;
    private final String words;

    MavMissionType(int number, String words) {
        this.number = number;
        this.words = words;
    }

    /** As people call it. */
    public String words() {
        return words;
    }

    /** As people call the one of that number, whatever it is. */
    static String words(int number) {
        return number >= 0 && number < values().length ? "its " + values()[number].words : "kind " + number;
    }

    public int number() {
        return number;
    }
}
