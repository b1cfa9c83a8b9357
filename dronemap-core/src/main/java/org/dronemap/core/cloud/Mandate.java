package org.dronemap.core.cloud;

import org.dronemap.core.command.CommandId;
import org.jspecify.annotations.Nullable;

/**
 * Authority for one send to a vehicle: command, control epoch, user, and the guard that may stop it.
 *
 * @param command null: the cloud's own housekeeping
 * @param epoch null where nobody has ever had control
 */
public record Mandate(@Nullable CommandId command, @Nullable Long epoch, String by, Fence fence) {
    /** What keeps the link to a vehicle: heartbeats, questions, measurements. */
    public static final Mandate HOUSEKEEPING = new Mandate(null, null, "dronemap", Fence.NONE);
}
