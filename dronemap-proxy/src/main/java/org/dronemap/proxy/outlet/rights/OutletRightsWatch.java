package org.dronemap.proxy.outlet.rights;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Rechecks four times a second the rights of users at the outlet, and stores their signing stamps once a minute. */
public final class OutletRightsWatch implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(OutletRightsWatch.class);
    private static final Duration RHYTHM = Duration.ofMillis(250);
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(2);
    private static final int MOST_WAITING = 1_000;
    private static final int ROUNDS_BETWEEN_STAMPS = 240;

    private final OutletRights rights;
    private final OutletKeys keys;
    private final Worker thread;
    // Owned by its thread.
    private int rounds;

    public OutletRightsWatch(OutletRights rights, OutletKeys keys, Time time) {
        this.rights = rights;
        this.keys = keys;
        this.thread = time.worker("outlet-rights", MOST_WAITING);
    }

    /** Looks from now on at those who are attached at the time, and does {@code often} as often. */
    public void start(Supplier<? extends List<? extends RightsHolder>> attached, Runnable often) {
        ScheduledTask unused = thread.every(RHYTHM, RHYTHM, () -> look(attached, often));
    }

    /**
     * Answers on its thread; null: the user is gone, may do nothing, or could not be looked up. False, without an answer,
     * when too many are asked about already, or the outlet is being closed.
     */
    public boolean ask(String user, Consumer<@Nullable Principal> answer) {
        try {
            thread.execute(() -> answer.accept(principal(user)));
            return true;
        } catch (RejectedExecutionException e) {
            LOG.debug("It is not looked up now whether {} may attach to the outlet", user, e);
            return false;
        }
    }

    private @Nullable Principal principal(String user) {
        try {
            return rights.principal(user).orElse(null);
        } catch (RuntimeException e) {
            LOG.error("It could not be looked up whether {} may attach to the outlet", user, e);
            return null;
        }
    }

    private void look(Supplier<? extends List<? extends RightsHolder>> attached, Runnable often) {
        try {
            often.run();
            judge(attached.get());
            if (++rounds % ROUNDS_BETWEEN_STAMPS == 0) {
                keys.storeStamps();
            }
        } catch (RuntimeException e) {
            LOG.error("It could not be looked up what users at the outlet may do; what they might before holds on", e);
        }
    }

    /** Sets what these may do now, on the thread that calls. */
    public void judge(List<? extends RightsHolder> attached) {
        for (RightsHolder holder : attached) {
            holder.setRights(rights.principal(holder.user()).orElse(null));
        }
    }

    @Override
    public void close() {
        try {
            if (thread.finish(LONGEST_CLOSE)) {
                keys.storeStamps();
            } else {
                LOG.warn("The time of the last signatures at the outlet was not kept, as the store takes too long");
            }
        } catch (RuntimeException e) {
            LOG.warn("The time of the last signatures at the outlet could not be kept", e);
        }
    }
}
