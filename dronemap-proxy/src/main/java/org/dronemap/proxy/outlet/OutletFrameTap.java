package org.dronemap.proxy.outlet;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.outlet.client.ClientMessageFilter;
import org.dronemap.proxy.session.FrameTap;
import org.jspecify.annotations.Nullable;

/** Passes the frames of one vehicle on to the outlet, and keeps the newest message of each kind. Any thread. */
public final class OutletFrameTap implements FrameTap {
    private static final int MOST_KEPT = 512;

    private final Outlet outlet;
    private final int component;
    private final Map<Integer, Frame> newest = new ConcurrentHashMap<>();
    private volatile List<MissionItemInt> mission = List.of();
    private volatile boolean missionKnown;
    private volatile @Nullable DroneId drone;

    /** {@code component} is the autopilot's. */
    OutletFrameTap(Outlet outlet, int component) {
        this.outlet = outlet;
        this.component = component;
    }

    public int component() {
        return component;
    }

    /** The autopilot's last message of this kind; null when none came. */
    @Nullable
    public Frame newest(int messageId) {
        return newest.get(messageId << 8 | component);
    }

    /** As it lies on the vehicle; null until it was read. */
    @Nullable
    public List<MissionItemInt> mission() {
        return missionKnown ? mission : null;
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
        Integer kind = frame.messageId() << 8 | frame.componentId();
        if (newest.size() < MOST_KEPT || newest.containsKey(kind)) {
            newest.put(kind, frame);
        }
        DroneId bound = drone;
        if (bound != null) {
            outlet.receivedFromVehicle(bound, frame);
        }
    }

    @Override
    public void missionRead(List<MissionItemInt> items) {
        mission = List.copyOf(items);
        missionKnown = true;
    }

    @Override
    public void sent(byte[] frame, SendAuthority mandate) {
        // What goes to vehicles is not for clients.
    }

    @Override
    public void bound(DroneId bound) {
        drone = bound;
        outlet.vehicleConnected(bound, this);
    }

    @Override
    public void ended() {
        DroneId bound = drone;
        if (bound != null) {
            outlet.vehicleDisconnected(bound, this);
        }
    }
}
