package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/** Remaining charge 0 to 100 %, volts, amperes; each unknown on its own. */
public record Battery(
        @Nullable Integer percent,
        @Nullable Double volts,
        @Nullable Double amps) {}
