package org.dronemap.core.audit;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.Instant;
import java.time.temporal.ChronoUnit;

/**
 * Links each audit record to the one before by a keyed hash, and signs chain heads; has no state but its key.
 * Thread-safe.
 */
public final class AuditChain {
    private final KeyedHash seal;

    public AuditChain(KeyedHash seal) {
        this.seal = seal;
    }

    /** Nothing that looks like a key gets into it. */
    public AuditRecord next(AuditHead head, AuditEntry entry) {
        long sequence = head.sequence() + 1;
        AuditEntry told = entry.withoutSecrets();
        return new AuditRecord(sequence, told, hash(head, sequence, told));
    }

    /** This very record was made here as the next one after that head. */
    public boolean follows(AuditHead head, AuditRecord record) {
        return same(record.hash(), hash(head, record.sequence(), record.entry()));
    }

    public SignedAuditHead sign(SignedAuditHead.Kind kind, AuditHead head, Instant at) {
        Instant kept = at.truncatedTo(ChronoUnit.MILLIS);
        return new SignedAuditHead(kind, head, kept, signature(kind, head, kept));
    }

    public boolean isSignedHere(SignedAuditHead signed) {
        return same(signed.signature(), signature(signed.kind(), signed.head(), signed.at()));
    }

    private String hash(AuditHead head, long sequence, AuditEntry entry) {
        return seal.of(new CanonicalEncoder("record")
                .add(head.hash())
                .add(sequence)
                .add(entry.at())
                .add(entry.by())
                .add(entry.organisation())
                .add(entry.key())
                .add(entry.face())
                .add(entry.operation())
                .add(entry.drone())
                .add(entry.epoch())
                .add(entry.command())
                .add(entry.parameters())
                .add(entry.outcome())
                .add(entry.reason())
                .add(entry.latencyMillis())
                .add(entry.ends())
                .bytes());
    }

    private String signature(SignedAuditHead.Kind kind, AuditHead head, Instant at) {
        return seal.of(new CanonicalEncoder("head")
                .add(kind)
                .add(head.sequence())
                .add(head.hash())
                .add(at)
                .bytes());
    }

    /** Takes as long for a wrong text as for the right one. */
    private static boolean same(String one, String other) {
        return MessageDigest.isEqual(one.getBytes(StandardCharsets.UTF_8), other.getBytes(StandardCharsets.UTF_8));
    }
}
