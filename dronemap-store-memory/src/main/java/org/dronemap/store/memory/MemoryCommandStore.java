package org.dronemap.store.memory;

import java.time.Instant;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.StoreException;
import org.dronemap.store.StoredInstant;

/** Keeps the log of commands to drones in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryCommandStore implements CommandStore {
    private static final Comparator<CommandRecord> NEWEST_FIRST = Comparator.comparing(CommandRecord::at)
            .thenComparing(command -> command.id().value())
            .reversed();

    private final Map<CommandId, CommandRecord> commands = new HashMap<>();

    @Override
    public synchronized boolean begin(CommandRecord command) {
        return commands.putIfAbsent(command.id(), stored(command)) == null;
    }

    @Override
    public synchronized void finish(CommandRecord command) {
        CommandRecord kept = commands.get(command.id());
        if (kept == null) {
            throw new StoreException("Command " + command.id() + " was never begun.");
        }
        Outcome had = kept.outcome();
        if (had == null) {
            commands.put(command.id(), stored(command));
        } else if (!had.equals(command.outcome())) {
            throw new StoreException("Command " + command.id() + " has ended already: " + had);
        }
    }

    @Override
    public synchronized Optional<CommandRecord> command(CommandId id) {
        return Optional.ofNullable(commands.get(id));
    }

    @Override
    public synchronized List<CommandRecord> commandsOf(DroneId drone, int limit) {
        return commands.values().stream()
                .filter(command -> command.drone().equals(drone))
                .sorted(NEWEST_FIRST)
                .limit(limit)
                .toList();
    }

    @Override
    public synchronized int endUnfinished(Outcome outcome, Instant at) {
        List<CommandRecord> open = commands.values().stream()
                .filter(command -> command.phase() != CommandPhase.DONE)
                .toList();
        open.forEach(command -> commands.put(command.id(), stored(command.ended(outcome, at))));
        return open.size();
    }

    private static CommandRecord stored(CommandRecord command) {
        Instant finishedAt = command.finishedAt();
        return new CommandRecord(
                command.id(),
                command.drone(),
                command.by(),
                command.face(),
                command.type(),
                command.summary(),
                StoredInstant.of(command.at()),
                command.phase(),
                command.progress(),
                command.outcome(),
                finishedAt == null ? null : StoredInstant.of(finishedAt),
                command.epoch(),
                command.content());
    }
}
