package org.dronemap.proxy.session;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.AutopilotVersion;

/** Keeps the AUTOPILOT_VERSION of vehicles that sent it before their first heartbeat opened a session. */
final class EarlyVersions {
    private final Map<Integer, Frame> versions = new HashMap<>();

    /** At most one frame a system id. */
    void received(Frame frame) {
        if (frame.messageId() == AutopilotVersion.ID) {
            versions.put(frame.systemId(), frame);
        }
    }

    /** Tells a link, just opened by a heartbeat, what was said before. */
    void replayTo(VehicleLink link, int systemId) {
        Frame version = versions.remove(systemId);
        if (version != null) {
            link.offer(version);
        }
    }
}
