package org.dronemap.core.drone;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Battery state of a vehicle: remaining charge 0 to 100 %, volts and amperes, each null while unknown.
 *
 * @param further batteries beside the main one, in the order of their numbers
 */
public record Battery(
        @Nullable Integer percent,
        @Nullable Double volts,
        @Nullable Double amps,
        List<Further> further) {
    /** A battery beside the main one, by the vehicle's number for it. */
    public record Further(
            int number,
            @Nullable Integer percent,
            @Nullable Double volts,
            @Nullable Double amps) {}

    public Battery {
        further = List.copyOf(further);
    }

    /** The only one. */
    public Battery(@Nullable Integer percent, @Nullable Double volts, @Nullable Double amps) {
        this(percent, volts, amps, List.of());
    }
}
