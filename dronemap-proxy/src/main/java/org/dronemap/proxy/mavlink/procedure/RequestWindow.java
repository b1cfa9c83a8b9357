package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** A sliding window of requests to a vehicle (such as missing parameters), each repeated until it is answered. */
final class RequestWindow<K> {
    private final int width;
    private final RetrySchedule pace;
    private final Consumer<K> ask;
    private final ArrayDeque<K> waiting = new ArrayDeque<>();
    private final Map<K, Asked> asked = new LinkedHashMap<>();
    private final Set<K> open = new HashSet<>();

    private record Asked(long atNanos, int tries) {}

    RequestWindow(int width, RetrySchedule pace, Consumer<K> ask) {
        this.width = width;
        this.pace = pace;
        this.ask = ask;
    }

    void add(Collection<K> questions) {
        questions.forEach(question -> {
            if (open.add(question)) {
                waiting.add(question);
            }
        });
    }

    /** True when that was a question that is still open. */
    boolean answered(K question) {
        if (!open.remove(question)) {
            return false;
        }
        if (asked.remove(question) == null) {
            waiting.remove(question);
        }
        return true;
    }

    boolean isOpen(K question) {
        return open.contains(question);
    }

    /** Was it asked at all? An answer to a question that was not put yet belongs to an older one. */
    boolean isAsked(K question) {
        return asked.containsKey(question);
    }

    boolean isEmpty() {
        return open.isEmpty();
    }

    /** Those asked so often in vain. */
    Set<K> askedInVain(int tries) {
        Set<K> vain = new HashSet<>();
        asked.forEach((question, last) -> {
            if (last.tries() >= tries) {
                vain.add(question);
            }
        });
        return vain;
    }

    /** {@code audible}: asking somebody who cannot be heard is no try. */
    void sendDue(long nowNanos, boolean audible) {
        for (Iterator<Map.Entry<K, Asked>> entries = asked.entrySet().iterator(); entries.hasNext(); ) {
            Map.Entry<K, Asked> entry = entries.next();
            Asked last = entry.getValue();
            if (nowNanos - last.atNanos() >= pace.pauseNanos(last.tries())) {
                entry.setValue(new Asked(nowNanos, audible ? last.tries() + 1 : last.tries()));
                ask.accept(entry.getKey());
            }
        }
        while (asked.size() < width) {
            K next = waiting.poll();
            if (next == null) {
                return;
            }
            asked.put(next, new Asked(nowNanos, 1));
            ask.accept(next);
        }
    }
}
