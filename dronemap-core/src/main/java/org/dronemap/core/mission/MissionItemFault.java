package org.dronemap.core.mission;

/**
 * A reason for which a vehicle does not fly one item of a mission as it is written.
 *
 * @param index of the item, from 0
 * @param field the item's member that is not to be had so, as clients write it
 * @param allowed what is, in words
 * @param reason a sentence without its subject, such as "does not wait at a waypoint"
 */
public record MissionItemFault(int index, String field, String allowed, String reason) {
    /** {@code vehicle}: as users know it, such as ArduPlane. */
    public String sentence(Mission mission, String vehicle) {
        return "Item " + (index + 1) + " (" + words(mission.items().get(index).kind()) + "): this vehicle (" + vehicle
                + ") " + reason + ".";
    }

    static String words(MissionItem.Kind kind) {
        return switch (kind) {
            case TAKE_OFF -> "take off";
            case WAYPOINT -> "waypoint";
            case RETURN_TO_LAUNCH -> "return to launch";
            case LAND -> "land";
            case WAIT -> "wait";
            case TAKE_PHOTO -> "take a photo";
            case SET_SERVO -> "set a servo";
            case LOOK_AT -> "look at";
            case LOOK_AHEAD -> "look ahead";
            case OTHER -> "something else";
        };
    }
}
