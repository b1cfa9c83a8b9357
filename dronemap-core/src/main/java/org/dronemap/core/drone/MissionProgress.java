package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * The mission on board a vehicle, as read back, and how far the vehicle has flown it.
 *
 * @param items what was read back from the vehicle; null as long as it was not read
 * @param hash stands for all that the vehicle keeps of it, finer settings included; null when it is not known
 * @param current index into the items that the vehicle heads for; null when it said none
 * @param phase whether it flies the mission; null when the vehicle does not say
 * @param reached indices of the items that it said it reached since the mission changed or was started, in order
 * @param notice a sentence when the mission is not the one that the cloud knew; null otherwise
 * @param landingSequence whether there is a landing sequence among the items; false where they are not known
 */
public record MissionProgress(
        @Nullable List<MissionItem> items,
        @Nullable String hash,
        @Nullable Integer current,
        @Nullable MissionPhase phase,
        List<Integer> reached,
        @Nullable String notice,
        boolean landingSequence) {
    public static final MissionProgress UNKNOWN = new MissionProgress(null, null, null, null, List.of(), null);

    /** Without a landing sequence. */
    public MissionProgress(
            @Nullable List<MissionItem> items,
            @Nullable String hash,
            @Nullable Integer current,
            @Nullable MissionPhase phase,
            List<Integer> reached,
            @Nullable String notice) {
        this(items, hash, current, phase, reached, notice, false);
    }

    /** Flown to the end: by the vehicle's own word, or when it gives none by the last item that it said it reached. */
    public boolean complete() {
        if (phase != null) {
            return phase == MissionPhase.COMPLETE;
        }
        return items != null && !items.isEmpty() && reached.contains(items.size() - 1);
    }
}
