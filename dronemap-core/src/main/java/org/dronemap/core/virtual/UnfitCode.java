package org.dronemap.core.virtual;

import org.dronemap.core.command.Refusal;

/**
 * Stable codes for why a drone cannot serve a virtual drone or a follow. What the gate says, and who has control, is
 * told by its own code ({@link Refusal#code}). What stands in the way of a request, too, has the same word there.
 */
public enum UnfitCode {
    CONTACT_NOT_GOOD(
            "contact-not-good", "There is no good contact with the drone.", "There is no good contact with it."),
    NOT_AT_REST("drone-not-at-rest", "The drone is armed or in the air.", "It is armed or in the air."),
    NOT_READY(
            "drone-not-ready-to-arm",
            "The vehicle's own checks do not let it arm.",
            "Its own checks do not let it arm."),
    LINK_TOO_LOSSY(
            "link-too-lossy",
            "The link loses more messages than a mission is trusted to.",
            "Its link loses 30 % of its messages."),
    LINK_FALLING(
            "link-falling",
            "The drone's link gets worse so quickly that it is expected to be lost soon.",
            "Its link gets worse (34 % of its messages are lost, usually 2 %): it is expected to be lost in about 40 s."),
    OTHER_KIND(
            "kind-not-wanted",
            "The drone is of another kind than the virtual drone needs.",
            "It is a fixed wing, not a multicopter."),
    CAPABILITY_MISSING(
            "capability-missing", "The vehicle cannot do what the virtual drone needs.", "It cannot take a picture."),
    POSITION_UNKNOWN(
            "position-unknown", "Where the drone stands is not known.", "Where it stands, or its home, is not known."),
    HOME_UNKNOWN(
            "home-unknown", "Where the drone's home is, is not known.", "Where it stands, or its home, is not known."),
    BATTERY_UNKNOWN(
            "battery-unknown",
            "How full the drone's battery is, is not known.",
            "How full its battery is, is not known."),
    OUTSIDE_AREA(
            "drone-outside-area",
            "The drone does not stand in the area that the virtual drone needs.",
            "It does not stand within 300 m of 47.00000, 8.00000."),
    ENDURANCE_TOO_SHORT(
            "endurance-too-short",
            "The battery does not last as long as the virtual drone needs.",
            "Its battery lasts for some 12 min, not for 18."),
    NO_HEADWAY(
            "no-headway",
            "Against the wind the drone makes no headway on the way.",
            "It makes no headway on its way: the mission takes more than it has."),
    BATTERY_TOO_LOW(
            "battery-too-low",
            "The battery has too little for the mission and the reserve.",
            "Its battery has 25 %; the mission takes some 12 %, and 20 % are kept in reserve."),
    TAKE_OFF_UNKNOWN(
            "take-off-height-unknown",
            "How high the drone has to take off is not known.",
            "How high it has to take off is not known."),
    FAILED_BEFORE(
            "mission-failed-before",
            "The drone could not go on with this mission a while ago; it is tried again later.",
            "It could not go on with this mission a while ago.");

    private final String word;
    private final String meaning;
    private final String example;

    UnfitCode(String word, String meaning, String example) {
        this.word = word;
        this.meaning = meaning;
        this.example = example;
    }

    /** Small letters with hyphens, such as {@code battery-too-low}. */
    public String word() {
        return word;
    }

    /** One line. */
    public String meaning() {
        return meaning;
    }

    /** A sentence that is told with it. */
    public String example() {
        return example;
    }
}
