package org.dronemap.ws.service;

import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * What becomes of one drone's tour after the plan was accepted.
 *
 * @param why what went wrong, as a sentence; null: nothing did
 * @param command the last one that was given for it; null: none yet
 */
public record PlanFlight(
        DroneId drone,
        Stage stage,
        @Nullable String why,
        @Nullable String command) {
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
