package org.dronemap.proxy.session;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.dronemap.mavlink.Frame;

/**
 * Recognises frames of a vehicle that already arrived over another of its links. Remembers so few that no numbering
 * comes round. Owned by the drone's lane.
 */
final class DuplicateFrameFilter {
    private static final int REMEMBERED = 128;

    private final ArrayDeque<Integer> order = new ArrayDeque<>();
    private final Set<Integer> seen = new HashSet<>();

    /** True for a frame that is byte for byte one of those heard lately. */
    boolean isEcho(Frame frame) {
        Integer print = Arrays.hashCode(frame.bytes());
        if (!seen.add(print)) {
            return true;
        }
        order.addLast(print);
        if (order.size() > REMEMBERED) {
            seen.remove(order.removeFirst());
        }
        return false;
    }
}
