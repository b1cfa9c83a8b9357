package org.dronemap.proxy.outlet.uplink;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionItemInt;
import org.jspecify.annotations.Nullable;

/**
 * Keeps the newest message of each kind, and the mission, of one connected vehicle, for answers to clients. Any thread.
 */
public final class VehicleFrameCache {
    private static final int MOST_KEPT = 512;

    private final int component;
    private final Map<Integer, Frame> newest = new ConcurrentHashMap<>();
    private volatile List<MissionItemInt> mission = List.of();
    private volatile boolean missionKnown;

    /** {@code component} is the autopilot's. */
    public VehicleFrameCache(int component) {
        this.component = component;
    }

    /** Keeps a frame as the newest of its kind. */
    public void put(Frame frame) {
        Integer kind = frame.messageId() << 8 | frame.componentId();
        if (newest.size() < MOST_KEPT || newest.containsKey(kind)) {
            newest.put(kind, frame);
        }
    }

    /** Keeps the mission that was read from the vehicle. */
    public void putMission(List<MissionItemInt> items) {
        mission = List.copyOf(items);
        missionKnown = true;
    }

    int component() {
        return component;
    }

    /** The autopilot's last message of this kind; null when none came. */
    @Nullable
    Frame newest(int messageId) {
        return newest.get(messageId << 8 | component);
    }

    /** As it lies on the vehicle; null until it was read. */
    @Nullable
    List<MissionItemInt> mission() {
        return missionKnown ? mission : null;
    }
}
