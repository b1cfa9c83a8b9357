package org.dronemap.core.audit;

import java.time.Instant;
import org.dronemap.core.stored.Stored;

/**
 * A head that this server vouches for: a line of the file beside the database, or a receipt that somebody keeps.
 *
 * @param at to the millisecond
 */
public record SignedHead(Kind kind, AuditHead head, Instant at, String signature) {
    /** What it says. */
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
