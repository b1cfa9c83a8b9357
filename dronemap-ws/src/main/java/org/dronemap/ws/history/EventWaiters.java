package org.dronemap.ws.history;

import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongFunction;
import org.dronemap.core.access.Principal;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Time;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.RateLimitRejection;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;

/**
 * Requests that wait for events, a bounded number of them. One thread looks for all of them when events have been stored,
 * and asks the store once for those that have come as far. Any thread.
 */
final class EventWaiters implements SmartLifecycle {
    static final int MOST = 1_000;
    static final int MOST_OF_ONE = 50;

    private static final Logger LOG = LoggerFactory.getLogger(EventWaiters.class);
    private static final Duration REST = Duration.ofHours(1);
    private static final Duration RETRY = Duration.ofSeconds(1);

    private final TelemetryStore store;
    private final CallerRights rights;
    private final Time time;
    private final Loop loop;
    private final AtomicLong stored = new AtomicLong();

    // Guarded by this.
    private final Set<Waiter> waiting = new LinkedHashSet<>();
    private final Map<String, Integer> ofAccount = new HashMap<>();
    private boolean running;

    /** Judges somebody who has waited as things are now. */
    @FunctionalInterface
    interface CallerRights {
        /**
         * Who the caller is now.
         *
         * @throws Rejection when they may look no longer
         */
        Principal now(EventFollow follow);
    }

    private record Waiter(EventFollow follow, CompletableFuture<Boolean> found) {}

    EventWaiters(TelemetryStore store, CallerRights rights, Time time) {
        this.store = store;
        this.rights = rights;
        this.time = time;
        this.loop = time.loop("event-waiters", this::turn);
    }

    /** Events have been stored. */
    void wake() {
        stored.incrementAndGet();
        loop.wake();
    }

    /** To be asked before the store is, and handed in with what was not found there. */
    long stamp() {
        return stored.get();
    }

    /** The answer as soon as there is one, or without events after so long. */
    CompletableFuture<FollowedEventsView> await(EventFollow follow, Duration longest, long stamp) {
        Waiter waiter = new Waiter(follow, new CompletableFuture<>());
        enter(waiter);
        if (stored.get() != stamp) {
            loop.wake();
        }
        return time.within(waiter.found(), longest, false)
                .whenComplete((done, failed) -> leave(waiter))
                .thenApply(unused -> follow.answer());
    }

    private synchronized void enter(Waiter waiter) {
        String account = waiter.follow().caller().principal().account();
        int before = ofAccount.getOrDefault(account, 0);
        if (before >= MOST_OF_ONE) {
            throw RateLimitRejection.of(
                    ServerProblem.WAITS_SPENT,
                    "As many requests wait for events as one user may have (" + MOST_OF_ONE + ")",
                    RETRY,
                    ProblemParameter.MOST.is(MOST_OF_ONE));
        }
        if (waiting.size() >= MOST) {
            throw Rejection.of(
                    ServerProblem.SERVER_BUSY,
                    "Too many requests wait for events; ask without wait.",
                    ProblemParameter.WHAT.is("requests that wait for events"));
        }
        waiting.add(waiter);
        ofAccount.put(account, before + 1);
        if (!running) {
            waiter.found().complete(false);
        }
    }

    private synchronized void leave(Waiter waiter) {
        if (waiting.remove(waiter)) {
            ofAccount.computeIfPresent(
                    waiter.follow().caller().principal().account(), (account, count) -> count == 1 ? null : count - 1);
        }
    }

    private synchronized List<Waiter> all() {
        return List.copyOf(waiting);
    }

    synchronized int count() {
        return waiting.size();
    }

    private long turn() {
        Map<Long, EventPage> read = new HashMap<>();
        LongFunction<EventPage> pages =
                number -> read.computeIfAbsent(number, after -> store.eventsAfter(after, EventFollow.PAGE));
        try {
            for (Waiter waiter : all()) {
                serve(waiter, pages);
            }
            return REST.toNanos();
        } catch (RuntimeException away) {
            LOG.warn("Events cannot be read for those who wait for them; it is tried again", away);
            return RETRY.toNanos();
        }
    }

    private void serve(Waiter waiter, LongFunction<EventPage> pages) {
        try {
            if (waiter.follow().look(pages, () -> rights.now(waiter.follow()))) {
                waiter.found().complete(true);
            }
        } catch (Rejection notAnyMore) {
            waiter.found().completeExceptionally(notAnyMore);
        }
    }

    @Override
    public synchronized void start() {
        running = true;
        loop.start();
    }

    /** Before the web server waits for requests to end. */
    @Override
    public void stop() {
        synchronized (this) {
            running = false;
        }
        loop.close();
        all().forEach(waiter -> waiter.found().complete(false));
    }

    @Override
    public synchronized boolean isRunning() {
        return running;
    }
}
