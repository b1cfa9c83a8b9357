package org.dronemap.core.zone;

import java.time.Instant;
import org.dronemap.core.mission.FenceZone;

/**
 * An area that drones stay in ({@code shape.inside()}), or out of; kept and enforced by the cloud, whatever the vehicle
 * itself keeps as its fence.
 *
 * @param name what people call it
 * @param changedBy who changed it last
 */
public record Zone(
        String id,
        String name,
        FenceZone shape,
        AltitudeBand band,
        Binding binding,
        Validity validity,
        BreachAction onBreach,
        String changedBy,
        Instant changedAt) {
    public Zone {
        ShapeFaults.of(shape).ifPresent(fault -> {
            throw new IllegalArgumentException(fault);
        });
    }

    /** "the no-fly zone “Airport”". */
    public String words() {
        return (shape.inside() ? "the zone “" : "the no-fly zone “") + name + "”";
    }
}
