package org.dronemap.core.command;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;

/** Stores the log of commands: intent before sending, outcome after; every write returns only after it is durable. */
public interface CommandStore {
    /** Writes the intent (or an already refused command); false when the id is taken, and then nothing is written. */
    boolean begin(CommandRecord command);

    /** Writes the outcome of a command that was begun. */
    void finish(CommandRecord command);

    Optional<CommandRecord> command(CommandId id);

    /** Newest first. */
    List<CommandRecord> commandsOf(DroneId drone, int limit);

    /** Ends what was under way when the server died; returns how many. */
    int endUnfinished(Outcome outcome, Instant at);
}
