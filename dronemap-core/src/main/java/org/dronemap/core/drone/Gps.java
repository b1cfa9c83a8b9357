package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/** Satellite reception: fix, satellites in use, horizontal dilution of precision. */
public record Gps(
        GpsFix fix, @Nullable Integer satellites, @Nullable Double hdop) {}
