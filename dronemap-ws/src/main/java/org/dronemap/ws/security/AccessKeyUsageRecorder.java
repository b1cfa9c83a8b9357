package org.dronemap.ws.security;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.audit.AuditedCall;

/** Stores when access keys were last used, at most once a minute for each. Any thread. */
final class AccessKeyUsageRecorder {
    private static final Duration ONCE_IN = Duration.ofMinutes(1);
    private static final int MOST_REMEMBERED = 10_000;

    private final AccessStore store;
    private final Clock clock;

    /** Guarded by this; the one used longest ago goes when it is full, and is written once more often then. */
    private final Map<String, Instant> written = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Instant> eldest) {
            return size() > MOST_REMEMBERED;
        }
    };

    AccessKeyUsageRecorder(AccessStore store, Clock clock) {
        this.store = store;
        this.clock = clock;
    }

    void used(String key) {
        Instant now = clock.instant();
        if (isDue(key, now)) {
            // Beside the call: it is not what the call is about.
            AuditedCall.aside(() -> store.accessKeyUsed(key, now));
        }
    }

    private synchronized boolean isDue(String key, Instant now) {
        Instant last = written.get(key);
        if (last != null && now.isBefore(last.plus(ONCE_IN))) {
            return false;
        }
        written.put(key, now);
        return true;
    }
}
