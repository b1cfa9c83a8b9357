package org.dronemap.ws.control;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/**
 * The drones that one client of the WebSocket stream steers, and the last notices sent to it about each. Guarded by
 * itself.
 */
final class SteeredDrones {
    private static final long BETWEEN_SENTENCES_NANOS = 1_000_000_000L;
    private static final int MOST_REMEMBERED = 64;

    private final Map<String, Principal> steered = new HashMap<>();
    private final Map<String, SentNotice> told = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, SentNotice> eldest) {
            return size() > MOST_REMEMBERED;
        }
    };

    private record SentNotice(String sentence, long nanos) {}

    /** It steers that drone in that name. */
    void add(String drone, Principal principal) {
        steered.put(drone, principal);
        told.remove(drone);
    }

    /** In whose name it steered that drone; null when it did not. From now on it does not. */
    @Nullable
    Principal remove(String drone) {
        return steered.remove(drone);
    }

    Set<String> drones() {
        return Set.copyOf(steered.keySet());
    }

    /** Setpoints come many times a second: the same sentence about the same drone is told once in one. */
    boolean mayNotify(String drone, String sentence, long nowNanos) {
        SentNotice last = told.get(drone);
        boolean again =
                last != null && last.sentence().equals(sentence) && nowNanos - last.nanos() < BETWEEN_SENTENCES_NANOS;
        if (!again) {
            told.put(drone, new SentNotice(sentence, nowNanos));
        }
        return !again;
    }
}
