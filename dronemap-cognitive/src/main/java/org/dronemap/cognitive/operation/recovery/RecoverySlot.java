package org.dronemap.cognitive.operation.recovery;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/**
 * The part of one drone in the plan of a recovery.
 *
 * @param place where it stands until its turn
 * @param layerMeters above its home, at which it flies there; where it lands, the height at which it stands
 * @param comesDown where it comes down
 * @param waits for whom, before each of its steps
 * @param startSeconds from the beginning of the recovery until it leaves its place, as far as can be said
 * @param downSeconds the same until it is down
 */
@Stored(names = "drone place layerMeters comesDown waits startSeconds downSeconds")
public record RecoverySlot(
        DroneId drone,
        Geodetic place,
        double layerMeters,
        Geodetic comesDown,
        List<RecoveryWait> waits,
        double startSeconds,
        double downSeconds) {
    public RecoverySlot {
        waits = List.copyOf(waits);
    }
}
