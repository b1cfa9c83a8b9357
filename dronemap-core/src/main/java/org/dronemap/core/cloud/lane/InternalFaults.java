package org.dronemap.core.cloud.lane;

import java.util.Optional;
import java.util.function.Supplier;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Turns an internal error in handling one command into a refusal of that command, and logs it. */
public final class InternalFaults {
    private static final Logger LOG = LoggerFactory.getLogger(InternalFaults.class);
    private static final Refusal WHY = new Refusal(
            OutcomeCode.SERVER_FAULT,
            "The cloud does not know how to do this: a fault of its own, which is logged for its makers.");

    private InternalFaults() {}

    /** What {@code judge} says, or why not when it fails. */
    public static Optional<Refusal> judging(String what, Supplier<Optional<Refusal>> judge) {
        try {
            return judge.get();
        } catch (RuntimeException | LinkageError e) {
            return fault(what, e);
        }
    }

    /** Why {@code work} was not done; empty when it was. */
    public static Optional<Refusal> doing(String what, Runnable work) {
        return judging(what, () -> {
            work.run();
            return Optional.empty();
        });
    }

    private static Optional<Refusal> fault(String what, Throwable e) {
        LOG.error("A fault of ours: what was asked for ({}) is refused", what, e);
        return Optional.of(WHY);
    }
}
