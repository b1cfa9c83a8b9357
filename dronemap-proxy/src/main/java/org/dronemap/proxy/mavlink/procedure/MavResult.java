package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;

/** Translates MAV_RESULT, a vehicle's answer to a command, into words and refusals. */
final class MavResult {
    static final int ACCEPTED = 0;
    static final int UNSUPPORTED = 3;
    static final int IN_PROGRESS = 5;

    private MavResult() {}

    static boolean isUnknown(int result) {
        return result == UNSUPPORTED || result == 7 || result == 9;
    }

    /** What a refusal by that result is called, with this sentence. */
    static Refusal refusal(int result, String sentence) {
        return new Refusal(
                switch (result) {
                    case 1 -> OutcomeCode.VEHICLE_BUSY;
                    case 2 -> OutcomeCode.VEHICLE_DENIED;
                    case UNSUPPORTED, 7, 8 -> OutcomeCode.VEHICLE_DOES_NOT_KNOW;
                    case 4 -> OutcomeCode.VEHICLE_FAILED;
                    case 6 -> OutcomeCode.VEHICLE_CANCELLED;
                    case 9 -> OutcomeCode.POSITIONS_NOT_TAKEN;
                    default -> OutcomeCode.VEHICLE_REFUSED;
                },
                sentence);
    }

    static String words(int result) {
        return switch (result) {
            case 1 -> "The vehicle cannot do that at the moment.";
            case 2 -> "The vehicle denied it and gave no reason.";
            case UNSUPPORTED -> "The vehicle does not know this command.";
            case 4 -> "The vehicle could not do it and gave no reason.";
            case 6 -> "The command was cancelled on the vehicle.";
            case 7, 8 -> "The vehicle takes this command only in another form.";
            case 9 -> "The vehicle does not take positions of this kind.";
            default -> "The vehicle answered with result " + result + ".";
        };
    }
}
