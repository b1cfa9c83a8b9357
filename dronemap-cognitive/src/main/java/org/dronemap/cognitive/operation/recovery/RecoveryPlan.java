package org.dronemap.cognitive.operation.recovery;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Result of planning a recovery: the parts of its drones, or why they cannot come down so.
 *
 * @param slots in the order in which they come down; none: it cannot be
 * @param fitting how many of them fit between the lowest height and the ceiling
 * @param why it cannot be, as sentences; null: it can
 */
public record RecoveryPlan(
        List<RecoverySlot> slots, int fitting, @Nullable String why) {
    public RecoveryPlan {
        slots = List.copyOf(slots);
    }

    static RecoveryPlan refused(int fitting, String why) {
        return new RecoveryPlan(List.of(), fitting, why);
    }
}
