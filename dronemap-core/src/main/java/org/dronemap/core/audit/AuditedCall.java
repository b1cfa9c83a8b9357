package org.dronemap.core.audit;

import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/**
 * The user call that the current threads work on, from its beginning to its end, and the audit record that it leaves.
 * The first change that a store makes durable during a call takes the call's record along, so that neither is ever
 * there without the other; a call without one leaves its record at its end. Belongs to the threads that work for the
 * call; guarded by its monitor.
 */
public final class AuditedCall {
    private static final ThreadLocal<@Nullable AuditedCall> CURRENT = new ThreadLocal<>();

    private final LongSupplier nanoTime;
    private final long beganNanos;
    private AuditEntry entry;
    private Stage stage = Stage.OPEN;
    private @Nullable Long sequence;
    private boolean quiet;
    private @Nullable AuditOutcome outcome;
    private @Nullable Consumer<AuditEntry> whenReleased;
    private String bare = "";

    private enum Stage {
        OPEN,
        LEFT_OUT,
        CLAIMED,
        WRITTEN
    }

    /** Something to do that may fail in its own way. */
    @FunctionalInterface
    public interface Work<T, E extends Exception> {
        T run() throws E;
    }

    public AuditedCall(AuditEntry entry, LongSupplier nanoTime) {
        this.entry = entry;
        this.nanoTime = nanoTime;
        this.beganNanos = nanoTime.getAsLong();
    }

    /** What this thread works for. */
    public static Optional<AuditedCall> current() {
        return Optional.ofNullable(CURRENT.get());
    }

    /** Does this work as a part of the call. */
    public <T, E extends Exception> T during(Work<T, E> work) throws E {
        return with(this, work);
    }

    /** For what is written beside a call and is not what the call is about. */
    public static void aside(Runnable work) {
        with(null, asWork(work));
    }

    /** The same of work with a result. */
    public static <T> T beside(Supplier<T> work) {
        return with(null, work::get);
    }

    private static <T, E extends Exception> T with(@Nullable AuditedCall activity, Work<T, E> work) throws E {
        AuditedCall before = CURRENT.get();
        CURRENT.set(activity);
        try {
            return work.run();
        } finally {
            if (before == null) {
                CURRENT.remove();
            } else {
                CURRENT.set(before);
            }
        }
    }

    private static Work<Boolean, RuntimeException> asWork(Runnable work) {
        return () -> {
            work.run();
            return true;
        };
    }

    /** The same work for another thread, still for what this thread works for now. */
    public static <T> Callable<T> carried(Callable<T> work) {
        AuditedCall activity = CURRENT.get();
        return activity == null ? work : () -> activity.<T, Exception>during(work::call);
    }

    /** The same work for another thread, still for what this thread works for now. */
    public static Runnable carried(Runnable work) {
        AuditedCall activity = CURRENT.get();
        return activity == null ? work : () -> activity.during(asWork(work));
    }

    public synchronized AuditEntry entry() {
        return entry;
    }

    /** It turns out to be about this; a key that was shown stays known. Returns what it was before. */
    synchronized AuditEntry become(AuditEntry what) {
        AuditEntry before = entry;
        entry = what.asked(
                what.by(),
                what.organisation() == null ? before.organisation() : what.organisation(),
                what.key() == null ? before.key() : what.key());
        return before;
    }

    /** Whoever asks has proved to be this one. */
    public synchronized void by(Principal principal) {
        entry = entry.asked(principal.name(), principal.organisation().value(), principal.key());
    }

    public synchronized void face(String face) {
        entry = entry.through(face);
    }

    public synchronized void operation(String operation) {
        entry = entry.doing(operation, entry.parameters());
    }

    public synchronized void drone(@Nullable String drone) {
        entry = entry.to(drone, entry.epoch());
    }

    /** What became of the control of that drone, if this is about it. */
    public synchronized void epoch(String drone, @Nullable Long epoch) {
        if (drone.equals(entry.drone())) {
            entry = entry.to(drone, epoch);
        }
    }

    /** It turns out to change nothing, or nothing that is taken down: it leaves no record, whatever becomes of it. */
    public synchronized void leaveOut() {
        stage = stage == Stage.OPEN ? Stage.LEFT_OUT : stage;
    }

    /** It leaves a record only when it is turned away. */
    public synchronized void leaveOutUnlessTurnedAway() {
        quiet = true;
    }

    /** Adds to the summary what is known to be fit for it. */
    public void parameters(String more) {
        parameters(more, more);
    }

    /** Adds to the summary; {@code bareMore} is for a call that turns out not to be understood: no texts of clients. */
    public synchronized void parameters(String more, String bareMore) {
        entry = entry.doing(entry.operation(), joined(entry.parameters(), more));
        bare = joined(bare, bareMore);
    }

    private static String joined(String before, String more) {
        return before.isEmpty() || more.isEmpty() ? before + more : before + ", " + more;
    }

    /** It was not understood: a text in it may be anything, a secret in the wrong field too. */
    public synchronized void withoutTexts() {
        entry = entry.doing(entry.operation(), bare);
    }

    /** It is not, or not wholly, carried out; the first who says why is believed. What a record leaves open, its end will tell. */
    public synchronized void turnedAway(AuditOutcome how, String why) {
        boolean first = entry.outcome() == AuditOutcome.SUCCEEDED
                || (outcome == null && entry.outcome() == AuditOutcome.UNDER_WAY);
        if (first) {
            entry = entry.ended(how, why, null);
        }
    }

    synchronized boolean isOpen() {
        return stage == Stage.OPEN;
    }

    /** What is to be written, for the first who asks; who gets it says afterwards what became of it. */
    public synchronized Optional<AuditEntry> claim() {
        if (stage != Stage.OPEN || (quiet && entry.outcome() == AuditOutcome.SUCCEEDED)) {
            return Optional.empty();
        }
        stage = Stage.CLAIMED;
        outcome = entry.outcome();
        return Optional.of(timed());
    }

    private AuditEntry timed() {
        return entry.latencyMillis() != null
                ? entry
                : entry.ended(entry.outcome(), entry.reason(), (nanoTime.getAsLong() - beganNanos) / 1_000_000);
    }

    public synchronized void written(long as) {
        stage = Stage.WRITTEN;
        sequence = as;
    }

    /** It could not be written, or there was nothing to write it with. */
    public void released() {
        Consumer<AuditEntry> last;
        synchronized (this) {
            stage = Stage.OPEN;
            outcome = null;
            last = whenReleased;
        }
        if (last != null) {
            claim().ifPresent(last);
        }
    }

    /** At the end of the call: what is still to be written, by {@code writer}. */
    void end(Consumer<AuditEntry> writer) {
        Optional<AuditEntry> left;
        synchronized (this) {
            whenReleased = writer;
            left = ending().or(this::claim);
        }
        left.ifPresent(writer);
    }

    /** Of a call that was turned away after its record had said that it was carried out; once, however often it ends. */
    private Optional<AuditEntry> ending() {
        if (sequence == null || outcome != AuditOutcome.SUCCEEDED || entry.outcome() == AuditOutcome.SUCCEEDED) {
            return Optional.empty();
        }
        outcome = entry.outcome();
        return Optional.of(timed().endingOf(sequence));
    }
}
