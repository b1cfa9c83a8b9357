package org.dronemap.core.audit;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Verifies the whole audit chain, also against the signed heads that were stored outside the database. One use each;
 * any thread.
 */
public final class AuditVerifier {
    private static final int AT_ONCE = 1_000;

    private final AuditStore store;
    private final AuditHeadStore heads;
    private final AuditChain chain;
    private final List<Expected> expected = new ArrayList<>();
    private @Nullable String doubt;
    private @Nullable SignedAuditHead restored;

    /** A head that the chain must have had, and who says so. */
    private record Expected(AuditHead head, String source) {}

    public AuditVerifier(AuditStore store, AuditHeadStore heads, AuditChain chain) {
        this.store = store;
        this.heads = heads;
        this.chain = chain;
    }

    /** Compares with a receipt too, if there is one. */
    public AuditVerdict verify(@Nullable SignedAuditHead receipt) {
        readHeads();
        if (receipt != null) {
            if (!chain.isSignedHere(receipt)) {
                doubt("The receipt is not one of this server, or it was changed.");
            } else {
                expect(receipt, "the receipt of ");
            }
        }
        expected.sort(Comparator.comparingLong(one -> one.head().sequence()));
        return walk(new ArrayDeque<>(expected));
    }

    private void doubt(String sentence) {
        if (doubt == null) {
            doubt = sentence;
        }
    }

    private void expect(SignedAuditHead signed, String source) {
        if (signed.head().sequence() > 0) {
            expected.add(new Expected(signed.head(), source + signed.at()));
        }
    }

    private void readHeads() {
        Optional<List<Optional<SignedAuditHead>>> lines = heads.all();
        if (lines.isEmpty()) {
            if (!store.head().equals(AuditHead.EMPTY)) {
                doubt("The file of heads is gone.");
            }
            return;
        }
        int number = 0;
        for (Optional<SignedAuditHead> line : lines.get()) {
            number++;
            Optional<SignedAuditHead> good = line.filter(chain::isSignedHere);
            if (good.isEmpty()) {
                doubt("Line " + number + " of the file of heads was changed, or another key signed it.");
            } else {
                read(good.get(), number);
            }
        }
    }

    private void read(SignedAuditHead signed, int number) {
        long sequence = signed.head().sequence();
        if (signed.kind() == SignedAuditHead.Kind.RESTORED) {
            restored = signed;
            expected.removeIf(one -> one.head().sequence() > sequence);
        } else if (number == 1 && (signed.kind() != SignedAuditHead.Kind.BEGUN || sequence > 0)) {
            doubt("The file of heads begins only at record " + sequence + ", of " + signed.at()
                    + "; what was kept before is gone.");
        }
        expect(signed, "what was kept at ");
    }

    private AuditVerdict walk(Deque<Expected> awaited) {
        AuditHead head = AuditHead.EMPTY;
        for (List<AuditRecord> page = page(head); !page.isEmpty(); page = page(head)) {
            for (AuditRecord record : page) {
                String wrong = wrong(head, record, awaited);
                if (wrong != null) {
                    return new AuditVerdict(head, head.sequence() + 1, wrong);
                }
                head = record.head();
            }
        }
        Expected beyond = awaited.peek();
        if (beyond != null) {
            return new AuditVerdict(head, head.sequence() + 1, missing(head, beyond));
        }
        return new AuditVerdict(head, null, doubt);
    }

    private List<AuditRecord> page(AuditHead head) {
        return store.after(head.sequence(), AT_ONCE);
    }

    private @Nullable String wrong(AuditHead head, AuditRecord record, Deque<Expected> awaited) {
        long sequence = head.sequence() + 1;
        if (record.sequence() != sequence) {
            return "Record " + sequence + " is missing; the next one is " + record.sequence() + ".";
        }
        if (!chain.follows(head, record)) {
            return "Record " + sequence + " was changed or put in its place, or the one before it was; or another key"
                    + " made it.";
        }
        for (Expected one = awaited.peek(); one != null && one.head().sequence() == sequence; one = awaited.peek()) {
            awaited.remove();
            if (!one.head().hash().equals(record.hash())) {
                return "Record " + sequence + ", or one before it, is not the one that " + one.source()
                        + " stands for: the chain was made anew." + restoredSince();
            }
        }
        return null;
    }

    private String missing(AuditHead head, Expected beyond) {
        return "The records from " + (head.sequence() + 1) + " to "
                + beyond.head().sequence() + " are missing: " + beyond.source() + " stands for them." + restoredSince();
    }

    private String restoredSince() {
        return restored == null
                ? ""
                : " A backup that ends with record " + restored.head().sequence() + " was restored at " + restored.at()
                        + ".";
    }
}
