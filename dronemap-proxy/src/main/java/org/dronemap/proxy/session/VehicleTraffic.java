package org.dronemap.proxy.session;

import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.jspecify.annotations.Nullable;

/**
 * What went between one vehicle and the cloud over one link since its session began.
 *
 * @param drone null until the vehicle is bound to one
 * @param lost messages missing from its sequence numbers
 * @param doubled copies of messages that had come already
 * @param dropped messages that found no room on their way to the drone
 * @param queue messages that wait now
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

    static VehicleTraffic of(
            LinkLabel label, Optional<DroneId> drone, LinkMeter.Counts counts, long sent, Mailbox mailbox) {
        return new VehicleTraffic(
                label.key(),
                label.transport(),
                drone.orElse(null),
                counts.received(),
                sent,
                counts.lost(),
                counts.doubled(),
                mailbox.dropped(),
                mailbox.waiting());
    }

    /** Together with another session under the same key: a connection that broke, and the one after it. */
    VehicleTraffic and(VehicleTraffic other) {
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
