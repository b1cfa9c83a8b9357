package org.dronemap.core.cloud;

import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;

/**
 * A command whose outcome is not known, or not written yet. Owned by the drone's lane; the records may be read from
 * anywhere.
 */
final class OpenCommand {
    private static final AtomicLong ORDER = new AtomicLong();

    private final long order = ORDER.incrementAndGet();
    private final Command command;
    private long lastSignNanos;
    private volatile CommandRecord record;
    private volatile CommandRecord told;

    OpenCommand(Command command, CommandRecord record, long nowNanos) {
        this.command = command;
        this.record = record;
        this.told = record;
        this.lastSignNanos = nowNanos;
    }

    Command command() {
        return command;
    }

    /** Rises with every command of this process. */
    long order() {
        return order;
    }

    CommandRecord record() {
        return record;
    }

    /** What others may see: an outcome only once it is written, so that nobody relies on one that a crash takes back. */
    CommandRecord told() {
        return told;
    }

    void update(CommandRecord newer, long nowNanos) {
        record = newer;
        told = newer;
        lastSignNanos = nowNanos;
    }

    /** Has its outcome, which is told once it is written. */
    void ended(CommandRecord done, long nowNanos) {
        record = done;
        lastSignNanos = nowNanos;
    }

    void written() {
        told = record;
    }

    boolean silentFor(long nowNanos, long nanos) {
        return nowNanos - lastSignNanos > nanos;
    }
}
