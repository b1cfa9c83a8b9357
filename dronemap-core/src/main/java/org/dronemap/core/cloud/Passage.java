package org.dronemap.core.cloud;

import org.dronemap.core.command.Refusal;
import org.jspecify.annotations.Nullable;

/** Whether a command may go as far as control of the drone is concerned. */
sealed interface Passage {
    /** It may, as long as the fence lets it; {@code epoch} is null where nobody has ever had control. */
    record Open(@Nullable Long epoch, Fence fence) implements Passage {}

    record Closed(Refusal why) implements Passage {}
}
