package org.dronemap.proxy.outlet.client;

import java.util.Set;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.MessageTable;

/** Decides which vehicle messages ground stations at the outlet get: all but exchanges between vehicle and cloud. */
public final class ClientMessageFilter {
    /** Missions, parameters, logs, files, keys, time, control, acknowledgements: the cloud itself talks about those. */
    static final Set<Integer> ENDS_IN_THE_CLOUD = Set.of(
            4, 6, 7, 20, 21, 22, 23, 37, 38, 39, 40, 41, 43, 44, 45, 47, 50, 51, 52, 53, 73, 75, 76, 77, 80, 110, 111,
            117, 118, 119, 120, 121, 122, 126, 130, 131, 256, 320, 321, 322, 323, 324, 345, 385, 512);

    /** Each counts; a newer one does not stand for an older one. */
    private static final Set<Integer> EVENTS = Set.of(46, 180, 253, 263);

    private ClientMessageFilter() {}

    /** What says that it is for somebody is for the cloud, which stands between; only what is for everybody passes. */
    public static boolean passes(Frame frame) {
        if (ENDS_IN_THE_CLOUD.contains(frame.messageId())) {
            return false;
        }
        MessageTable.Entry entry = MessageTable.find(frame.messageId());
        return entry == null || entry.targetOffset() < 0 || frame.u8(entry.targetOffset()) == 0;
    }

    public static boolean isEvent(Frame frame) {
        return EVENTS.contains(frame.messageId());
    }
}
