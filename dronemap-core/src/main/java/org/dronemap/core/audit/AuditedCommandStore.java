package org.dronemap.core.audit;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.UUID;
import java.util.function.LongSupplier;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** A CommandStore that also writes an audit record of each command's intent and of its outcome. */
public final class AuditedCommandStore implements CommandStore {
    private final CommandStore store;
    private final AuditStore audit;
    private final LongSupplier nanoTime;

    public AuditedCommandStore(CommandStore store, AuditStore audit, LongSupplier nanoTime) {
        this.store = store;
        this.audit = audit;
        this.nanoTime = nanoTime;
    }

    @Override
    public boolean begin(CommandRecord command) {
        Optional<AuditedCall> call = AuditedCall.current().filter(AuditedCall::isOpen);
        AuditedCall activity = call.orElseGet(() -> new AuditedCall(entry(command), nanoTime));
        AuditEntry before = activity.become(entry(command));
        try {
            if (!activity.during(() -> store.begin(command))) {
                activity.become(before);
                return false;
            }
            write(activity);
            return true;
        } catch (RuntimeException e) {
            if (call.isEmpty()) {
                audit.appendLater(activity.entry());
            }
            throw e;
        }
    }

    @Override
    public void finish(CommandRecord command) {
        AuditedCall end = new AuditedCall(ending(command), nanoTime);
        try {
            end.during(() -> {
                store.finish(command);
                return command;
            });
            write(end);
        } catch (RuntimeException e) {
            end.claim().ifPresent(audit::appendLater);
            throw e;
        }
    }

    /** Where the store has not taken the record along with the command. */
    private void write(AuditedCall activity) {
        activity.claim().ifPresent(entry -> activity.written(audit.append(entry).sequence()));
    }

    @Override
    public Optional<CommandRecord> command(CommandId id) {
        return store.command(id);
    }

    @Override
    public List<CommandRecord> commandsOf(DroneId drone, int limit) {
        return store.commandsOf(drone, limit);
    }

    @Override
    public int endUnfinished(Outcome outcome, Instant at) {
        int ended = store.endUnfinished(outcome, at);
        for (AuditRecord open : audit.underWay()) {
            AuditEntry entry = open.entry();
            audit.append(entry.ending(at, of(outcome), reason(outcome), millis(entry.at(), at))
                    .endingOf(open.sequence()));
        }
        return ended;
    }

    private static AuditEntry entry(CommandRecord command) {
        Outcome outcome = command.outcome();
        Instant ended = command.finishedAt();
        return new AuditEntry(
                command.at(),
                command.by(),
                null,
                null,
                command.face(),
                command.type().substring(0, 1).toLowerCase(Locale.ROOT)
                        + command.type().substring(1),
                command.drone().value(),
                command.epoch(),
                named(command.id()),
                AuditText.withoutSecrets(command.summary()),
                outcome == null ? AuditOutcome.UNDER_WAY : of(outcome),
                outcome == null ? null : reason(outcome),
                ended == null ? null : millis(command.at(), ended),
                null);
    }

    private static AuditEntry ending(CommandRecord command) {
        Outcome outcome = command.outcome();
        Instant ended = command.finishedAt();
        if (outcome == null || ended == null) {
            throw new IllegalArgumentException("the command " + command.id() + " has not ended");
        }
        return entry(command).ending(ended, of(outcome), reason(outcome), millis(command.at(), ended));
    }

    /** Clients choose ids: what could be a key is told by its hash, so that the end of the command still finds it. */
    private static String named(CommandId id) {
        String told = AuditText.withoutSecrets(id.value());
        return told.equals(id.value())
                ? told
                : "hidden-" + UUID.nameUUIDFromBytes(id.value().getBytes(StandardCharsets.UTF_8));
    }

    private static Long millis(Instant from, Instant to) {
        return Math.max(0, Duration.between(from, to).toMillis());
    }

    private static AuditOutcome of(Outcome outcome) {
        return switch (outcome.kind()) {
            case SUCCEEDED -> AuditOutcome.SUCCEEDED;
            case REFUSED -> AuditOutcome.REFUSED;
            case FAILED -> AuditOutcome.FAILED;
            case TIMED_OUT -> AuditOutcome.TIMED_OUT;
            case SUPERSEDED -> AuditOutcome.SUPERSEDED;
            case UNKNOWN -> AuditOutcome.UNKNOWN;
        };
    }

    private static @Nullable String reason(Outcome outcome) {
        String said = outcome.by() == null ? outcome.reason() : outcome.by() + ": " + outcome.reason();
        return AuditText.withoutSecretsOrNull(said);
    }
}
