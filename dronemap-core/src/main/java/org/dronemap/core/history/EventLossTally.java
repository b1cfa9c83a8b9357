package org.dronemap.core.history;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** Adds up events that could not be stored, until the store is told of them. Any thread. */
final class EventLossTally {
    // Guarded by this.
    private @Nullable EventLoss sum;

    synchronized void add(@Nullable EventLoss loss) {
        if (loss != null) {
            sum = sum == null ? loss : sum.plus(loss);
        }
    }

    void add(List<HistoryEvent> events) {
        events.forEach(event -> add(EventLoss.of(event)));
    }

    synchronized @Nullable EventLoss drain() {
        EventLoss taken = sum;
        sum = null;
        return taken;
    }

    synchronized boolean isEmpty() {
        return sum == null;
    }
}
