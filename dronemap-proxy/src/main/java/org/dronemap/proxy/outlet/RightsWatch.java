package org.dronemap.proxy.outlet;

import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Asks four times a second what the users of attached clients may do, and keeps the time of signatures once a minute; on a
 * thread of its own, which may wait for the store.
 */
final class RightsWatch implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(RightsWatch.class);
    private static final long RHYTHM_MILLIS = 250;
    private static final int ROUNDS_BETWEEN_STAMPS = 240;

    private final OutletRights rights;
    private final OutletKeys keys;
    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread created = new Thread(task, "outlet-rights");
        created.setDaemon(true);
        return created;
    });
    // Owned by its thread.
    private int rounds;

    RightsWatch(OutletRights rights, OutletKeys keys) {
        this.rights = rights;
        this.keys = keys;
    }

    /** Looks at the clients that there are from now on, and does {@code often} as often. */
    void start(OutletRoom room, Runnable often) {
        var unused = thread.scheduleWithFixedDelay(
                () -> look(room, often), RHYTHM_MILLIS, RHYTHM_MILLIS, TimeUnit.MILLISECONDS);
    }

    /** Answers on its thread; null: the user is gone, may do nothing, or could not be looked up. */
    void ask(String user, Consumer<@Nullable Principal> answer) {
        try {
            thread.execute(() -> answer.accept(principal(user)));
        } catch (RejectedExecutionException e) {
            LOG.debug("The outlet is being closed", e);
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

    private void look(OutletRoom room, Runnable often) {
        try {
            often.run();
            judge(room);
            if (++rounds % ROUNDS_BETWEEN_STAMPS == 0) {
                keys.storeStamps();
            }
        } catch (RuntimeException e) {
            LOG.error("It could not be looked up what users at the outlet may do; what they might before holds on", e);
        }
    }

    /** On the thread that calls. */
    void judge(OutletRoom room) {
        for (OutletClient client : room.clients()) {
            client.rightsAre(rights.principal(client.user()).orElse(null));
        }
    }

    @Override
    public void close() {
        thread.shutdown();
        try {
            if (thread.awaitTermination(2, TimeUnit.SECONDS)) {
                keys.storeStamps();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (RuntimeException e) {
            LOG.warn("The time of the last signatures at the outlet could not be kept", e);
        }
    }
}
