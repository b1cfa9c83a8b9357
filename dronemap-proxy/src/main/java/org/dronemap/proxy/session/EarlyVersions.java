package org.dronemap.proxy.session;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.AutopilotVersion;

/** Keeps the AUTOPILOT_VERSION of vehicles that sent it before their first heartbeat opened a session. */
final class EarlyVersions {
    private static final int MOST = 256;

    /** By system and component: parts of a vehicle have versions of their own. */
    private final Map<Key, Frame> versions = new HashMap<>();

    private record Key(int system, int component) {
        static Key of(Frame frame) {
            return new Key(frame.systemId(), frame.componentId());
        }
    }

    /** At most one frame a component, for at most so many. */
    void received(Frame frame) {
        if (frame.messageId() == AutopilotVersion.ID
                && (versions.size() < MOST || versions.containsKey(Key.of(frame)))) {
            versions.put(Key.of(frame), frame);
        }
    }

    /** Tells a link, just opened by this heartbeat, what its sender said before. */
    void replayTo(VehicleLink link, Frame heartbeat) {
        Frame version = versions.remove(Key.of(heartbeat));
        if (version != null) {
            link.offer(version);
        }
    }
}
