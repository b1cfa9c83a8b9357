package org.dronemap.core.audit;

import java.time.Instant;
import org.dronemap.core.stored.Stored;

/**
 * A head of the audit chain signed by this server: a line in the file beside the database, or a user's receipt.
 *
 * @param at to the millisecond
 */
public record SignedAuditHead(Kind kind, AuditHead head, Instant at, String signature) {
    /** Kinds of signed audit heads: beginning of the file, anchor of the chain's length, or restore of a backup. */
    @Stored(names = "BEGUN ANCHORED RESTORED")
    public enum Kind {
        /** The file begins here; what was before, it does not know. */
        BEGUN,
        /** The chain was so long at that time. */
        ANCHORED,
        /** A backup was restored: the chain goes on from here, and what was anchored beyond is gone. */
        RESTORED
    }
}
