package org.dronemap.proxy.outlet.client;

import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Predicate;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;

/**
 * The bounded send queue of one ground station at the outlet: replies in order, of telemetry only the newest. Bounded;
 * what is replaced or falls out is counted. Owned by the outlet's thread.
 */
final class ClientSendQueue {
    private static final int MOST_EVENTS = 512;
    private static final int MOST_TELEMETRY = 8_192;

    private final ArrayDeque<ClientMessage> events = new ArrayDeque<>();
    private final Map<Kind, ClientMessage.OfVehicle> telemetry = new LinkedHashMap<>();
    private long dropped;

    /** Of one component of one drone there is one newest. */
    private record Kind(DroneId drone, int component, int message) {}

    boolean isEmpty() {
        return events.isEmpty() && telemetry.isEmpty();
    }

    int waiting() {
        return events.size() + telemetry.size();
    }

    long dropped() {
        return dropped;
    }

    /** Answers and events find room while they are few. */
    boolean hasRoom() {
        return events.size() < MOST_EVENTS / 2;
    }

    /** In order; the oldest falls out of a full queue. */
    void add(ClientMessage letter) {
        if (events.size() == MOST_EVENTS) {
            events.removeFirst();
            dropped++;
        }
        events.addLast(letter);
    }

    /** Takes the place of an older one of its kind. */
    void addNewest(ClientMessage.OfVehicle letter) {
        Frame frame = letter.frame();
        Kind kind = new Kind(letter.drone(), frame.componentId(), frame.messageId());
        if (telemetry.remove(kind) != null || telemetry.size() >= MOST_TELEMETRY) {
            dropped++;
        }
        if (telemetry.size() < MOST_TELEMETRY) {
            telemetry.put(kind, letter);
        }
    }

    /** Hands letters out until one is not taken. */
    void drain(Predicate<ClientMessage> taker) {
        while (!events.isEmpty()) {
            if (!taker.test(events.peekFirst())) {
                return;
            }
            events.removeFirst();
        }
        Iterator<ClientMessage.OfVehicle> newest = telemetry.values().iterator();
        while (newest.hasNext()) {
            if (!taker.test(newest.next())) {
                return;
            }
            newest.remove();
        }
    }
}
