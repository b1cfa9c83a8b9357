package org.dronemap.core.conduct;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.TransientFailure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Sends the commands of one operation and collects their outcomes. Owned by the conductor's thread. */
final class OperationCommands {
    private static final Logger LOG = LoggerFactory.getLogger(OperationCommands.class);
    /** The gate, which hears of more, gives up after 90 s without a sign; a transfer that goes on may take as long as it does. */
    private static final Duration LONGEST_WITHOUT_NEWS = Duration.ofMinutes(3);

    private static final String NEVER_SENT = "It was not sent: the server stopped, or could not write it down, before.";

    private final DroneGateway crew;
    private final LeaseHolder.Operation holder;
    private final LongSupplier nanoTime;
    private final Map<CommandId, LastProgress> newest = new HashMap<>();
    /** Of what could not be given; a server that stopped before it was given has no entry. */
    private final Map<CommandId, Refusal> neverGiven = new HashMap<>();

    /** Newest record of a command, and when it was first seen in that form. */
    private record LastProgress(CommandRecord record, long seenNanos) {}

    OperationCommands(DroneGateway crew, LeaseHolder.Operation holder, LongSupplier nanoTime) {
        this.crew = crew;
        this.holder = holder;
        this.nanoTime = nanoTime;
    }

    void submit(OperationAction.SendCommand<?> what) {
        try {
            crew.command(holder, what.drone(), what.id(), what.command());
        } catch (UnknownDroneException removed) {
            LOG.info(
                    "{} is not told to {}: it was removed",
                    what.drone(),
                    what.command().summary());
            neverGiven.put(
                    what.id(),
                    new Refusal(OutcomeCode.DRONE_REMOVED, "It was not sent: there is no such drone any more."));
        } catch (RuntimeException e) {
            OutcomeCode code = e instanceof TransientFailure ? OutcomeCode.NOT_WRITTEN_DOWN : OutcomeCode.SERVER_FAULT;
            neverGiven.put(what.id(), new Refusal(code, NEVER_SENT));
            LOG.error("{} was not told to {}", what.drone(), what.command().summary(), e);
        }
    }

    /** Empty while it is under way; what nobody knows of was never sent. */
    Optional<Outcome> outcome(SavedOperation.Given given) {
        Optional<CommandRecord> record = crew.record(given.command());
        if (record.isEmpty()) {
            return Optional.of(new Outcome.Refused(
                    "gate", neverGiven.getOrDefault(given.command(), new Refusal(OutcomeCode.NOT_SENT, NEVER_SENT))));
        }
        Outcome outcome = record.get().outcome();
        if (outcome != null) {
            return Optional.of(outcome);
        }
        long now = nanoTime.getAsLong();
        LastProgress news = newest.compute(
                given.command(),
                (id, last) -> last == null || !last.record().equals(record.get())
                        ? new LastProgress(record.get(), now)
                        : last);
        return now - news.seenNanos() > LONGEST_WITHOUT_NEWS.toNanos()
                ? Optional.of(new Outcome.Unknown("Nothing was heard of it; look at the drone."))
                : Optional.empty();
    }

    void forget(SavedOperation.Given given) {
        newest.remove(given.command());
        neverGiven.remove(given.command());
    }
}
