package org.dronemap.core.access;

import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * MAVLink signing state of one drone: whether it is required, the signing keys and the last signing stamp.
 *
 * @param key null: none was made
 * @param nextKey the key that a change began with and that the vehicle may use already; null: no change is open
 * @param proven the vehicle was heard signing with {@code key}
 * @param stamp the last number that a signed message of either side carried; only rises, none is used twice
 */
public record LinkSecurity(
        DroneId drone,
        LinkSigningPolicy policy,
        @Nullable LinkKey key,
        @Nullable LinkKey nextKey,
        boolean proven,
        long stamp) {
    public LinkSecurity {
        if (key == null && (nextKey != null || proven)) {
            throw new IllegalArgumentException("without a key nothing can follow it or be proven");
        }
    }

    /** What holds for a drone that nobody secured. */
    public static LinkSecurity none(DroneId drone) {
        return new LinkSecurity(drone, LinkSigningPolicy.OFF, null, null, false, 0);
    }
}
