package org.dronemap.ws.plan;

import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.problem.ProblemCode;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/**
 * How far one drone of an accepted plan is: uploading its mission, waiting, arming, started or failed.
 *
 * @param why what went wrong; null: nothing did
 * @param command the last one that was given for it; null: none yet
 */
record DroneLaunchStatus(
        DroneId drone,
        Stage stage,
        @Nullable Reason why,
        @Nullable String command) {
    /** What went wrong: a code of the catalogue and a sentence. */
    public record Reason(String code, String sentence) {
        static Reason of(ProblemCode code, String sentence) {
            return new Reason(code.word(), sentence);
        }

        static Reason of(Rejection why) {
            return of(why.code(), why.sentence());
        }
    }

    /** How far it has come. */
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
