package org.dronemap.core.audit;

import java.time.Clock;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Opens and ends the audit record of each user call (page, REST, SOAP, stream): exactly one record a call. Any thread.
 */
public final class AuditRecorder {
    /** So many refusals of strangers are recorded one by one, and one more a second. */
    public static final long ANONYMOUS_REFUSALS = 2_000;

    private static final Logger LOG = LoggerFactory.getLogger(AuditRecorder.class);

    private final AuditStore store;
    private final Clock clock;
    private final LongSupplier nanoTime;
    private final AnonymousRefusalLimiter strangers;
    private final LongAdder late = new LongAdder();

    /** {@code anonymousRefusals}: how many of strangers are recorded one by one, such as {@link #ANONYMOUS_REFUSALS}. */
    public AuditRecorder(AuditStore store, Clock clock, LongSupplier nanoTime, long anonymousRefusals) {
        this.store = store;
        this.clock = clock;
        this.nanoTime = nanoTime;
        this.strangers = new AnonymousRefusalLimiter(anonymousRefusals, nanoTime);
    }

    /** A call that has just come in; nothing of it is known yet but how. */
    public AuditedCall begin(String face, String operation) {
        return new AuditedCall(entry(face, operation), nanoTime);
    }

    /** Returns when the record is durable; where it cannot be at the moment, it is kept to be written later. */
    public void end(AuditedCall activity) {
        activity.end(this::write);
    }

    private void write(AuditEntry entry) {
        boolean stranger = entry.by() == null && entry.outcome() != AuditOutcome.SUCCEEDED;
        if (stranger && !strangers.tryAcquire()) {
            return;
        }
        keep(entry);
        long untold = stranger ? strangers.drainUnrecorded() : 0;
        if (untold > 0) {
            keep(entry("server", "refused strangers")
                    .doing("refused strangers", untold + " more calls of strangers were refused")
                    .ended(AuditOutcome.REFUSED, "Too many to write down each.", null));
        }
    }

    private void keep(AuditEntry entry) {
        try {
            store.append(entry);
        } catch (RuntimeException e) {
            late.increment();
            LOG.error("What {} did ({}) cannot be written down now; it is kept for later", entry.by(), entry, e);
            store.appendLater(entry);
        }
    }

    /** Records that could not be written when they should have been, since the start. */
    public long lateCount() {
        return late.sum();
    }

    private AuditEntry entry(String face, String operation) {
        return new AuditEntry(
                clock.instant(),
                null,
                null,
                null,
                face,
                operation,
                null,
                null,
                null,
                "",
                AuditOutcome.SUCCEEDED,
                null,
                null,
                null);
    }
}
