package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.rule.ControlRules;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.time.Time;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stores the intent of a command before it is sent; for commands to safety it waits a moment at most. What brings a
 * drone to safety waits for that a moment at most, and what a rule commands not at all: neither is kept back by a store
 * that is in trouble. Any thread.
 */
final class CommandIntentWriter {
    private static final Logger LOG = LoggerFactory.getLogger(CommandIntentWriter.class);
    private static final Duration LONGEST_FOR_SAFETY = Duration.ofSeconds(1);

    private final CommandStore store;
    private final StoreWriter journal;
    private final Time time;

    CommandIntentWriter(CommandStore store, StoreWriter journal, Time time) {
        this.store = store;
        this.journal = journal;
        this.time = time;
    }

    /** False when the id is not new; then nothing is to be sent. */
    boolean write(Command command, CommandRecord record) {
        return ControlRules.bringsToSafety(command) ? writeSoon(record) : store.begin(record);
    }

    private boolean writeSoon(CommandRecord record) {
        CompletableFuture<Boolean> begun = new CompletableFuture<>();
        journal.write(
                "the intent of " + record.summary(),
                () -> begun.complete(store.begin(record)),
                () -> begun.completeExceptionally(new IllegalStateException("its intent was not written")));
        try {
            return time.join(begun, LONGEST_FOR_SAFETY);
        } catch (CompletionException e) {
            LOG.error("The intent of {} is not written yet; it is sent all the same", record.summary(), e);
            return true;
        }
    }

    /** In its turn, which is before that of its outcome. Does not wait. */
    void writeLater(CommandRecord record) {
        journal.write("what a rule commands: " + record.summary(), () -> store.begin(record), () -> {});
    }
}
