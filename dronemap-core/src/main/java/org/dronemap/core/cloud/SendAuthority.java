package org.dronemap.core.cloud;

import org.dronemap.core.command.CommandId;
import org.jspecify.annotations.Nullable;

/**
 * On whose authority something is sent to a vehicle: command, control epoch, user, and the guard that may stop it.
 *
 * @param command null: the cloud's own housekeeping
 * @param epoch null where nobody has ever had control
 */
public record SendAuthority(
        @Nullable CommandId command, @Nullable Long epoch, String by, EpochGuard fence) {
    /** What keeps the link to a vehicle: heartbeats, questions, measurements. */
    public static final SendAuthority HOUSEKEEPING = new SendAuthority(null, null, "dronemap", EpochGuard.NONE);
}
