package org.dronemap.core.separation;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Finds out which drones do not give way any more: who was sent on, is down, or was taken by somebody. */
final class YieldingReview {
    private YieldingReview() {}

    static void review(SeparationRound round) {
        Map<DroneId, TrackedDrone> seen = new HashMap<>();
        round.picture.drones().forEach(drone -> seen.put(drone.id(), drone));
        Map<DroneId, Yielding> kept = new HashMap<>();
        round.yielding.forEach((id, yielding) -> {
            TrackedDrone drone = seen.get(id);
            Yielding now = drone == null ? null : review(round, drone, yielding);
            if (now != null) {
                kept.put(id, now);
            }
        });
        round.yielding.clear();
        round.yielding.putAll(kept);
    }

    /** Null: it does not give way any more. */
    private static @Nullable Yielding review(SeparationRound round, TrackedDrone drone, Yielding yielding) {
        if (drone.handling() != Handling.COMMANDED) {
            return null;
        }
        if (!yielding.isOrdered()) {
            // Asked for anew in each round as long as it means to set off; who has risen as it might is free.
            return yielding.mayRise() && drone.state().airborne() ? null : yielding;
        }
        if (!drone.state().airborne()) {
            return null;
        }
        if (drone.waits() || drone.isLost()) {
            return drone.waits() ? yielding.seenStanding() : yielding;
        }
        boolean wentOn = yielding.stood() || yielding.isUnheeded(round.picture.now());
        return wentOn ? null : yielding;
    }
}
