package org.dronemap.ws.plan;

import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.problem.ProblemCode;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/**
 * Launch status of one drone of an accepted plan: uploading its mission, waiting, arming, started or failed.
 *
 * @param why what went wrong; null: nothing did
 * @param command the last one that was given for it; null: none yet
 */
record DroneLaunchStatus(
        DroneId drone,
        Stage stage,
        @Nullable Reason why,
        @Nullable String command) {
    /** Reason for a failure: a code of the problem catalogue and a sentence. */
    public record Reason(String code, String sentence) {
        static Reason of(ProblemCode code, String sentence) {
            return new Reason(code.word(), sentence);
        }

        static Reason of(Rejection why) {
            return of(why.code(), why.sentence());
        }
    }

    /** Stage of one drone's launch, from upload of its mission to its start, hold-back or failure. */
    public enum Stage {
        UPLOADING,
        UPLOADED,
        /** Leaves later than others, as the plan says. */
        WAITING,
        ARMING,
        STARTING,
        STARTED,
        /** Not started, since something was not as the plan needs it. */
        HELD_BACK,
        FAILED;

        /** Nothing more happens by itself. */
        boolean isEnd() {
            return this == UPLOADED || this == STARTED || this == HELD_BACK || this == FAILED;
        }
    }
}
