package org.dronemap.sim.link;

import java.nio.ByteBuffer;
import java.util.function.Consumer;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.jspecify.annotations.Nullable;

/**
 * A simulated vehicle of the fleet together with its link to the server and its frame reader. Owned by the fleet's
 * thread.
 */
final class SimulatedFleetMember {
    private final FrameReader reader = new FrameReader();
    private final SimulatedVehicle vehicle;
    private @Nullable SimulatorLink uplink;

    SimulatedFleetMember(java.util.function.Function<Consumer<byte[]>, SimulatedVehicle> maker) {
        this.vehicle = maker.apply(this::send);
    }

    void attach(SimulatorLink newUplink) {
        uplink = newUplink;
    }

    void received(ByteBuffer bytes) {
        reader.read(bytes, frame -> {
            if (frame.verified()) {
                vehicle.receive(frame);
            }
        });
    }

    private void send(byte[] bytes) {
        if (uplink != null) {
            uplink.send(bytes);
        }
    }

    void advance(long untilMillis, long nowNanos) {
        if (uplink != null) {
            uplink.maintain(nowNanos);
            if (vehicle.changeAddress()) {
                uplink.renew();
            }
        }
        vehicle.advance(untilMillis);
    }

    SimulatedVehicle vehicle() {
        return vehicle;
    }

    void close() {
        if (uplink != null) {
            uplink.close();
        }
    }

    long dropped() {
        return uplink == null ? 0 : uplink.dropped();
    }
}
