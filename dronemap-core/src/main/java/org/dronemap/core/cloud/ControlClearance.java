package org.dronemap.core.cloud;

import org.dronemap.core.command.Refusal;
import org.jspecify.annotations.Nullable;

/** Result of checking a command against control of its drone: cleared under a control epoch, or refused. */
sealed interface ControlClearance {
    /** It may, as long as the fence lets it; {@code epoch} is null where nobody has ever had control. */
    record Cleared(@Nullable Long epoch, EpochGuard fence) implements ControlClearance {}

    record Refused(Refusal why) implements ControlClearance {}
}
