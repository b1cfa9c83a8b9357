package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;

/** Translates MAV_MISSION_RESULT, a vehicle's answer in the mission protocol, into words and refusals. */
final class MavMissionResult {
    static final int ACCEPTED = 0;
    static final int ERROR = 1;
    static final int INVALID_SEQUENCE = 13;
    static final int DENIED = 14;
    static final int CANCELLED = 15;

    private MavMissionResult() {}

    /** What may be cured by beginning again. */
    static boolean isPassing(int result) {
        return result == ERROR || result == CANCELLED;
    }

    /** What may be cured by waiting. */
    static boolean isBusy(int result) {
        return result == ERROR || result == DENIED;
    }

    static Refusal refusal(int result) {
        return refusal(result, words(result));
    }

    /** What a refusal by that result is called, with this sentence. */
    static Refusal refusal(int result, String sentence) {
        return new Refusal(
                switch (result) {
                    case 2 -> OutcomeCode.POSITIONS_NOT_TAKEN;
                    case 3 -> OutcomeCode.MISSION_ITEM_NOT_KNOWN;
                    case 4 -> OutcomeCode.MISSION_TOO_LONG;
                    case 5, 6, 7, 8, 9, 10, 11, 12 -> OutcomeCode.MISSION_VALUE_NOT_TAKEN;
                    case INVALID_SEQUENCE -> OutcomeCode.MISSION_OUT_OF_ORDER;
                    case DENIED -> OutcomeCode.VEHICLE_DENIED;
                    case CANCELLED -> OutcomeCode.VEHICLE_CANCELLED;
                    default -> OutcomeCode.VEHICLE_REFUSED;
                },
                sentence);
    }

    static String words(int result) {
        return switch (result) {
            case 2 -> "The vehicle does not take positions of this kind.";
            case 3 -> "The vehicle does not know an item of this mission.";
            case 4 -> "The vehicle has no room for so many mission items.";
            case 5, 6, 7, 8, 9, 10, 11, 12 ->
                "The vehicle finds a value of the mission invalid (result " + result + ").";
            case INVALID_SEQUENCE -> "The vehicle got the mission items out of order.";
            case DENIED -> "The vehicle takes and gives no mission now.";
            case CANCELLED -> "The vehicle cancelled the transfer.";
            default -> "The vehicle answered the mission transfer with an error (result " + result + ").";
        };
    }
}
