package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/** Battery state of a vehicle: remaining charge 0 to 100 %, volts and amperes, each null while unknown. */
public record Battery(
        @Nullable Integer percent,
        @Nullable Double volts,
        @Nullable Double amps) {}
