package org.dronemap.proxy.session;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.jspecify.annotations.Nullable;

/**
 * Counters of the traffic between one vehicle or robot and the server over one link.
 *
 * @param drone null until the vehicle is bound to one
 * @param lost messages missing from its sequence numbers
 * @param doubled copies of messages that had come already
 * @param dropped messages that found no room on their way to the drone
 * @param queue messages of the vehicle that wait now
 */
public record VehicleTraffic(
        DroneKey key,
        String transport,
        @Nullable DroneId drone,
        long received,
        long sent,
        long lost,
        long doubled,
        long dropped,
        int queue) {

    /** Together with another session under the same key: a connection that broke, and the one after it. */
    public VehicleTraffic and(VehicleTraffic other) {
        return new VehicleTraffic(
                key,
                transport,
                drone == null ? other.drone : drone,
                received + other.received,
                sent + other.sent,
                lost + other.lost,
                doubled + other.doubled,
                dropped + other.dropped,
                queue + other.queue);
    }
}
