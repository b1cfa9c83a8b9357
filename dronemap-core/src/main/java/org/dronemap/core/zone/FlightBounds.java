package org.dronemap.core.zone;

import java.util.Optional;
import org.dronemap.core.mission.FenceArea;
import org.jspecify.annotations.Nullable;

/**
 * Area and altitude band that an access key's flights must stay within, besides all zones.
 *
 * @param area null: anywhere
 */
public record FlightBounds(@Nullable FenceArea area, AltitudeBand band) {

    /** The part of bounds that something goes beyond. */
    public enum Side {
        AREA,
        ALTITUDE
    }

    public FlightBounds {
        if (area != null) {
            if (!area.inside()) {
                throw new IllegalArgumentException("flights stay within bounds: the area must be one to stay in");
            }
            ShapeValidator.of(area).ifPresent(fault -> {
                throw new IllegalArgumentException(fault);
            });
        }
    }

    /** Where these bounds reach farther than those; empty when they lie within them. */
    public Optional<Side> beyond(FlightBounds outer) {
        if (outer.area != null && (area == null || !AreaContainment.holds(outer.area, area))) {
            return Optional.of(Side.AREA);
        }
        return band.isWithin(outer.band) ? Optional.empty() : Optional.of(Side.ALTITUDE);
    }

    /** As far as the area goes, at any height. */
    FlightBounds atAnyHeight() {
        return new FlightBounds(area, AltitudeBand.ALL);
    }
}
