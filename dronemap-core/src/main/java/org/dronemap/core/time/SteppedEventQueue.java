package org.dronemap.core.time;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Event queue of stepped (simulated) time, ordered by due time and arrival. Whoever is in the middle of something is
 * not given the next thing, even when what it does waits for others. Owned by the one thread that steps.
 */
final class SteppedEventQueue {
    private static final Logger LOG = LoggerFactory.getLogger(SteppedEventQueue.class);

    private final PriorityQueue<Entry> entries = new PriorityQueue<>(
            Comparator.comparingLong((Entry entry) -> entry.dueNanos).thenComparingLong(entry -> entry.number));
    private final List<RuntimeException> failures = new ArrayList<>();
    private long numbers;

    /** Of all that belongs together: when it is over, nothing of it is done any more. */
    static final class Lifetime {
        private boolean over;
        private boolean stopped;

        void end() {
            over = true;
        }

        void stopped(boolean now) {
            stopped = now;
        }
    }

    /** Whoever does one thing after the other. */
    static final class Owner {
        private final String name;
        private final Lifetime life;
        private boolean busy;

        Owner(String name, Lifetime life) {
            this.name = name;
            this.life = life;
        }
    }

    /** Something that is due. */
    static final class Entry {
        private final Owner owner;
        private final long dueNanos;
        private final long number;
        private final Runnable work;

        private Entry(Owner owner, long dueNanos, long number, Runnable work) {
            this.owner = owner;
            this.dueNanos = dueNanos;
            this.number = number;
            this.work = work;
        }

        long dueNanos() {
            return dueNanos;
        }
    }

    Entry add(Owner owner, long dueNanos, Runnable work) {
        Entry entry = new Entry(owner, dueNanos, numbers++, work);
        entries.add(entry);
        return entry;
    }

    void remove(Entry entry) {
        entries.remove(entry);
    }

    /** The first whose owner is free; null: there is none until then. */
    @Nullable
    Entry next(long untilNanos) {
        List<Entry> passed = new ArrayList<>(0);
        Entry found = null;
        for (Entry entry = entries.peek();
                entry != null && entry.dueNanos <= untilNanos && found == null;
                entry = entries.peek()) {
            entries.remove();
            if (entry.owner.busy || entry.owner.life.stopped) {
                passed.add(entry);
            } else if (!entry.owner.life.over) {
                found = entry;
            }
        }
        entries.addAll(passed);
        return found;
    }

    void work(Entry entry) {
        entry.owner.busy = true;
        try {
            entry.work.run();
        } catch (RuntimeException e) {
            LOG.error("{} failed at one thing; it goes on with the next", entry.owner.name, e);
            failures.add(e);
        } finally {
            entry.owner.busy = false;
        }
    }

    List<RuntimeException> failures() {
        return List.copyOf(failures);
    }
}
