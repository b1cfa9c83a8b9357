package org.dronemap.core.virtual;

import java.time.Instant;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * The real drone assigned to a virtual drone's run, why it was chosen, and its command under way.
 *
 * @param choice why this one
 * @param first the tour's waypoint that it begins with, counted from 0
 * @param takeOffMeters above home; null: it does not take off
 * @param command the last one that it was given; null: none of this stage
 * @param tries that failed, of this stage; of arming and starting together
 * @param changedAt when stage or command last changed
 */
public record VirtualRunAssignment(
        DroneChoice choice,
        int first,
        @Nullable Double takeOffMeters,
        @Nullable CommandId command,
        int tries,
        Instant changedAt) {
    public DroneId drone() {
        return choice.chosen();
    }

    /** In another stage, or asked again. */
    VirtualRunAssignment fresh(int failed, Instant now) {
        return new VirtualRunAssignment(choice, first, takeOffMeters, null, failed, now);
    }

    VirtualRunAssignment given(CommandId next, Instant now) {
        return new VirtualRunAssignment(choice, first, takeOffMeters, next, tries, now);
    }
}
