package org.dronemap.core.cloud.rule;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;

/**
 * Progress of one command under way, up to its stored outcome. Owned by the drone's lane; the records may be read from
 * anywhere.
 */
public final class CommandTracker {
    /** On its way to the vehicle within the server; whoever gave it sees something else by then. */
    public static final Duration LONGEST_WAY = Duration.ofSeconds(10);

    public static final Outcome LATE = new Outcome.TimedOut(
            "It was not on its way to the vehicle within " + LONGEST_WAY.toSeconds() + " s, so it was not sent.");

    private static final AtomicLong ORDER = new AtomicLong();

    private final long order = ORDER.incrementAndGet();
    private final Command command;
    private final long givenNanos;
    private long lastSignNanos;
    private volatile CommandRecord record;
    private volatile CommandRecord published;

    /** {@code activeNanos} stand still while the process does, {@code nowNanos} do not. */
    public CommandTracker(Command command, CommandRecord record, long activeNanos, long nowNanos) {
        this.givenNanos = nowNanos;
        this.command = command;
        this.record = record;
        this.published = record;
        this.lastSignNanos = activeNanos;
    }

    public boolean isLate(long nowNanos) {
        return nowNanos - givenNanos > LONGEST_WAY.toNanos();
    }

    public Command command() {
        return command;
    }

    /** Rises with every command of this process. */
    public long order() {
        return order;
    }

    public CommandRecord record() {
        return record;
    }

    /** What others may see: an outcome only once it is written, so that nobody relies on one that a crash takes back. */
    public CommandRecord published() {
        return published;
    }

    public void update(CommandRecord newer, long nowNanos) {
        record = newer;
        published = newer;
        lastSignNanos = nowNanos;
    }

    /** Has its outcome, which is told once it is written. */
    public void ended(CommandRecord done, long nowNanos) {
        record = done;
        lastSignNanos = nowNanos;
    }

    public void written() {
        published = record;
    }

    boolean silentFor(long nowNanos, long nanos) {
        return nowNanos - lastSignNanos > nanos;
    }
}
