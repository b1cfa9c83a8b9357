package org.dronemap.core.audit;

import java.time.Clock;
import java.time.Duration;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Signs the current head of the audit chain every ten seconds and stores it outside the database. A thread of its own;
 * any may call.
 */
public final class AuditHeadWriter implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(AuditHeadWriter.class);
    private static final Duration PERIOD = Duration.ofSeconds(10);
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(5);

    private final AuditStore store;
    private final AuditHeadStore heads;
    private final AuditChain chain;
    private final Clock clock;
    // guarded by this
    private AuditHead kept = AuditHead.EMPTY;
    private final Worker thread;

    public AuditHeadWriter(AuditStore store, AuditHeadStore heads, AuditChain chain, Time time) {
        this.store = store;
        this.heads = heads;
        this.chain = chain;
        this.clock = time.clock();
        this.thread = time.worker("audit-heads", 1);
    }

    public void start() {
        if (heads.all().isEmpty()) {
            add(SignedAuditHead.Kind.BEGUN, store.head());
        }
        ScheduledTask unused = thread.every(PERIOD, PERIOD, this::keep);
    }

    /** The chain of now, vouched for; kept here as well. */
    public SignedAuditHead receipt() {
        return add(SignedAuditHead.Kind.ANCHORED, store.head());
    }

    /** The chain has become another one, on purpose. */
    public void restored() {
        add(SignedAuditHead.Kind.RESTORED, store.head());
    }

    private void keep() {
        try {
            AuditHead now = store.head();
            if (!now.equals(kept())) {
                add(SignedAuditHead.Kind.ANCHORED, now);
            }
        } catch (RuntimeException e) {
            LOG.error("The head of the audit chain could not be kept; it is tried again", e);
        }
    }

    private synchronized AuditHead kept() {
        return kept;
    }

    private synchronized SignedAuditHead add(SignedAuditHead.Kind kind, AuditHead head) {
        SignedAuditHead signed = chain.sign(kind, head, clock.instant());
        heads.add(signed);
        kept = head;
        return signed;
    }

    @Override
    public void close() {
        if (!thread.finish(LONGEST_CLOSE)) {
            LOG.warn("The head of the audit chain was still being kept at the end");
        }
        keep();
    }
}
