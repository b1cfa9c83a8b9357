package org.dronemap.core.cloud;

import org.dronemap.core.command.Refusal;
import org.jspecify.annotations.Nullable;

/** Clearance of a command by control of the drone: open under an epoch, or closed with a refusal. */
sealed interface ControlClearance {
    /** It may, as long as the fence lets it; {@code epoch} is null where nobody has ever had control. */
    record Cleared(@Nullable Long epoch, EpochGuard fence) implements ControlClearance {}

    record Refused(Refusal why) implements ControlClearance {}
}
