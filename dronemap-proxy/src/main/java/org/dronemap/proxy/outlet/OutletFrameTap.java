package org.dronemap.proxy.outlet;

import java.util.List;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.outlet.client.ClientMessageFilter;
import org.dronemap.proxy.outlet.uplink.VehicleFrameCache;
import org.dronemap.proxy.session.FrameTap;
import org.jspecify.annotations.Nullable;

/** Passes the frames of one vehicle on to the outlet, and keeps the newest of them. Any thread. */
final class OutletFrameTap implements FrameTap {
    private final OutletLoop loop;
    private final VehicleFrameCache cache;
    private volatile @Nullable DroneId drone;

    /** {@code component} is the autopilot's. */
    OutletFrameTap(OutletLoop loop, int component) {
        this.loop = loop;
        cache = new VehicleFrameCache(component);
    }

    @Override
    public void received(Frame frame) {
        // Not all that is heard is let in.
    }

    @Override
    public void admitted(Frame frame) {
        if (!ClientMessageFilter.passes(frame)) {
            return;
        }
        cache.put(frame);
        DroneId bound = drone;
        if (bound != null) {
            loop.receivedFromVehicle(bound, frame);
        }
    }

    @Override
    public void missionRead(List<MissionItemInt> items) {
        cache.putMission(items);
    }

    @Override
    public void sent(byte[] frame, SendAuthority mandate) {
        // What goes to vehicles is not for clients.
    }

    @Override
    public void bound(DroneId bound) {
        drone = bound;
        loop.vehicleConnected(bound, cache);
    }

    @Override
    public void ended() {
        DroneId bound = drone;
        if (bound != null) {
            loop.vehicleDisconnected(bound, cache);
        }
    }
}
