package org.dronemap.core.history;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.LongAdder;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes telemetry points and history events to the store in batches, on a thread of its own. Both queues are bounded:
 * what finds no room, because the store is away, slow or full, is dropped and counted, and whoever brings it never
 * waits.
 */
public final class TelemetryWriter implements TelemetrySink, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(TelemetryWriter.class);
    private static final Comparator<TelemetryPoint> BY_DRONE =
            Comparator.comparing(point -> point.drone().value());
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(5);
    /** So often a batch is tried that a store which answers does not take. */
    private static final int MOST_TRIES = 10;

    /** So often in a row it must answer and refuse the batch after that. */
    private static final int REFUSALS = 2;

    /** So long after a drop the store counts as too slow. */
    private static final long SLOW_NANOS = 60_000_000_000L;

    /**
     * Settings for writing telemetry in batches: interval, batch size, queue size and retry pause.
     *
     * @param every a batch is written this often, or sooner when one is full
     * @param batch the most points, or events, that are written at once
     * @param room the most points, or events, that wait
     * @param pause between two tries while the store does not take anything
     */
    public record BatchSettings(Duration every, int batch, int room, Duration pause) {
        /** Well within a second to the disk; room for some seconds of thousands of drones. */
        public static final BatchSettings DEFAULT =
                new BatchSettings(Duration.ofMillis(250), 20_000, 60_000, Duration.ofSeconds(2));
    }

    /** Telemetry points and events that are written to the store at once. */
    private record Batch(
            List<TelemetryPoint> points,
            List<HistoryEvent> events,
            @Nullable EventLoss lost) {
        int size() {
            return points.size() + events.size();
        }

        boolean isEmpty() {
            return size() == 0 && lost == null;
        }

        boolean changesEvents() {
            return !events.isEmpty() || lost != null;
        }
    }

    private final TelemetryStore store;
    private final BatchSettings rhythm;
    private final BlockingQueue<TelemetryPoint> points;
    private final BlockingQueue<HistoryEvent> events;
    private final LongAdder written = new LongAdder();
    private final LongAdder dropped = new LongAdder();
    private final EventLossTally losses = new EventLossTally();
    private final CopyOnWriteArrayList<Runnable> eventListeners = new CopyOnWriteArrayList<>();
    private final Time time;
    private final Loop loop;
    private volatile boolean closed;
    private volatile @Nullable String failure;
    private volatile int underWay;
    private volatile long droppedNanos;
    // Owned by the loop.
    private @Nullable Batch refused;
    private int tries;
    private int refusals;
    private boolean opened;

    public TelemetryWriter(TelemetryStore store, BatchSettings rhythm, Time time) {
        this.store = store;
        this.rhythm = rhythm;
        this.points = new ArrayBlockingQueue<>(rhythm.room());
        this.events = new ArrayBlockingQueue<>(rhythm.room());
        this.time = time;
        this.loop = time.loop("telemetry", this::turn);
    }

    public void start() {
        loop.start();
    }

    @Override
    public void point(TelemetryPoint point) {
        if (!points.offer(point)) {
            drop(1);
        } else if (points.size() == rhythm.batch()) {
            loop.wake();
        }
    }

    @Override
    public void event(HistoryEvent event) {
        if (!events.offer(event)) {
            losses.add(EventLoss.of(event));
            drop(1);
        }
    }

    /** Called, on the thread that stores, whenever there are new entries in the series of events; must return soon. */
    public void onEventsStored(Runnable listener) {
        eventListeners.add(listener);
    }

    /** Any thread. */
    public HistoryHealth health() {
        String trouble = failure;
        if (trouble == null && droppedNanos != 0 && time.nanos() - droppedNanos < SLOW_NANOS) {
            trouble = "The telemetry store is too slow: not all that comes can be kept.";
        }
        return new HistoryHealth(trouble, written.sum(), dropped.sum(), points.size() + events.size() + underWay);
    }

    private void drop(int count) {
        dropped.add(count);
        droppedNanos = time.nanos();
    }

    /** The batch that was refused goes first. */
    private long turn() {
        if (!opened && !done(() -> store.openEvents(time.clock().instant()))) {
            return rhythm.pause().toNanos();
        }
        if (!opened) {
            opened = true;
            eventListeners.forEach(Runnable::run);
        }
        write();
        // Whoever is ended before that leaves a gap.
        if (closed && refused == null && events.isEmpty() && losses.isEmpty()) {
            boolean unused = done(store::closeEvents);
        }
        return (refused == null ? rhythm.every() : rhythm.pause()).toNanos();
    }

    private void write() {
        boolean free = refused == null || triedAgain(refused);
        for (Batch batch = free ? next() : null; batch != null && !batch.isEmpty(); batch = next()) {
            underWay = batch.size();
            if (tried(batch)) {
                underWay = 0;
            } else {
                refuse(batch);
                if (!closed || batch.size() == 0) {
                    break;
                }
            }
        }
    }

    private void refuse(Batch batch) {
        if (closed) {
            giveUp(batch);
            underWay = 0;
            return;
        }
        refused = batch;
        tries = 1;
        refusals = 0;
    }

    /** True when it need not be tried any more: it is written, or the store takes others but not this one. */
    private boolean triedAgain(Batch batch) {
        boolean done = tried(batch);
        // One that answers just after may have come back in between.
        refusals = !done && tries >= MOST_TRIES && answers() ? refusals + 1 : 0;
        tries++;
        boolean given = !done && (closed || refusals >= REFUSALS);
        if (given) {
            giveUp(batch);
        }
        if (done || given) {
            refused = null;
            underWay = 0;
        }
        return done || given;
    }

    private void giveUp(Batch batch) {
        losses.add(batch.lost());
        losses.add(batch.events());
        if (batch.size() > 0) {
            drop(batch.size());
        }
    }

    private Batch next() {
        List<TelemetryPoint> taken = new ArrayList<>();
        points.drainTo(taken, rhythm.batch());
        // Those of one drone side by side: who reads later reads one drone.
        taken.sort(BY_DRONE);
        List<HistoryEvent> happened = new ArrayList<>();
        events.drainTo(happened, rhythm.batch());
        return new Batch(taken, happened, losses.drain());
    }

    private boolean answers() {
        try {
            return !store.server().isEmpty();
        } catch (RuntimeException away) {
            return false;
        }
    }

    private boolean tried(Batch batch) {
        boolean done = done(() -> store.append(batch.points(), batch.events(), batch.lost()));
        if (done) {
            written.add(batch.size());
            if (batch.changesEvents()) {
                eventListeners.forEach(Runnable::run);
            }
        }
        return done;
    }

    private boolean done(Runnable work) {
        try {
            work.run();
            if (failure != null) {
                LOG.info("Telemetry is written again; {} points and events were dropped so far", dropped.sum());
            }
            failure = null;
            return true;
        } catch (RuntimeException e) {
            if (failure == null) {
                LOG.warn("Telemetry cannot be written for now; what does not fit into memory is dropped", e);
            }
            failure = "Telemetry cannot be written: " + e.getMessage();
            return false;
        }
    }

    /** Writes what waits, within some seconds. */
    @Override
    public void close() {
        closed = true;
        if (!loop.finish(LONGEST_CLOSE)) {
            LOG.warn("Not all telemetry was written when the writer was closed");
        }
    }
}
