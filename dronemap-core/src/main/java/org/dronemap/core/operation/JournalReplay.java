package org.dronemap.core.operation;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Replays an operation's journal and compares each decision with the stored one; finds non-determinism. Takes a journal
 * in parts, in order. One thread.
 */
public final class JournalReplay<S, I> {
    private final OperationKind<S, I> kind;
    private @Nullable S state;
    private long next;
    private @Nullable Difference difference;

    /** The first entry that does not follow; {@code decided} is what is decided on it now, or why nothing can be. */
    public record Difference(long number, String written, String decided) {}

    public JournalReplay(OperationKind<S, I> kind) {
        this.kind = kind;
    }

    /** Goes on with these entries, up to the first that differs. */
    public void replay(List<JournalEntry> entries) {
        for (JournalEntry entry : entries) {
            if (difference != null) {
                return;
            }
            if (entry.number() != next) {
                difference = new Difference(next, "", "The journal goes on with the entry " + entry.number() + ".");
                return;
            }
            next++;
            if (!entry.setsAside()) {
                replay(entry);
            }
        }
    }

    private void replay(JournalEntry entry) {
        S before = state;
        try {
            if (before == null) {
                state = kind.codec().state(entry.input());
                compare(entry, entry.input(), kind.codec().state(state));
                return;
            }
            I input = kind.codec().input(entry.input());
            compare(entry, entry.input(), kind.codec().input(input));
            OperationDecision<S, I> decision = kind.machine().decide(before, input);
            compare(entry, entry.decision(), kind.codec().decision(decision));
            state = decision.next();
        } catch (IllegalArgumentException unreadable) {
            difference =
                    new Difference(entry.number(), entry.decision(), "It cannot be read: " + unreadable.getMessage());
        }
    }

    private void compare(JournalEntry entry, String written, String now) {
        if (difference == null && !written.equals(now)) {
            difference = new Difference(entry.number(), written, now);
        }
    }

    /** How many entries were looked at. */
    public long count() {
        return next;
    }

    /** Empty while everything was decided as it was written down. */
    public Optional<Difference> difference() {
        return Optional.ofNullable(difference);
    }
}
