package org.dronemap.core.cloud;

import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;

/** A command that has no outcome yet. Owned by the drone's lane; the record may be read from anywhere. */
final class OpenCommand {
    private static final AtomicLong ORDER = new AtomicLong();

    private final long order = ORDER.incrementAndGet();
    private final Command command;
    private long lastSignNanos;
    private volatile CommandRecord record;

    OpenCommand(Command command, CommandRecord record, long nowNanos) {
        this.command = command;
        this.record = record;
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

    void update(CommandRecord newer, long nowNanos) {
        record = newer;
        lastSignNanos = nowNanos;
    }

    boolean silentFor(long nowNanos, long nanos) {
        return nowNanos - lastSignNanos > nanos;
    }
}
