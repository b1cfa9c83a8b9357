package org.dronemap.core.drone;

import java.util.List;

/**
 * Report from a vehicle session of the links that reach its vehicle now, the best one first.
 *
 * @param key where commands go: the better link when there are several
 * @param others further links that the same vehicle is heard on
 */
public record LinkReport(DroneKey key, String transport, LinkQuality quality, LinkTrend trend, List<DroneKey> others) {
    public LinkReport {
        others = List.copyOf(others);
    }

    /** Nothing is known of where its quality goes. */
    public LinkReport(DroneKey key, String transport, LinkQuality quality, List<DroneKey> others) {
        this(key, transport, quality, LinkTrend.UNKNOWN, others);
    }
}
