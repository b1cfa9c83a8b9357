package org.dronemap.core.time;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.RejectedExecutionException;

/** A {@link Worker} in stepped (simulated) time. */
final class SteppedWorker implements Worker {
    private final SteppedProcess time;
    private final SteppedEventQueue agenda;
    private final SteppedEventQueue.Owner owner;
    private final int capacity;
    private final Set<SteppedEventQueue.Entry> due = new HashSet<>();
    private int waiting;
    private boolean closed;

    SteppedWorker(
            SteppedProcess time, SteppedEventQueue agenda, SteppedEventQueue.Lifetime life, String name, int capacity) {
        this.time = time;
        this.agenda = agenda;
        this.owner = new SteppedEventQueue.Owner(name, life);
        this.capacity = capacity;
    }

    @Override
    public void execute(Runnable work) {
        time.requireStepper();
        if (closed || waiting >= capacity) {
            throw new RejectedExecutionException("closed, or too much waits");
        }
        waiting++;
        add(time.nanos(), () -> {
            waiting--;
            work.run();
        });
    }

    @Override
    public ScheduledTask after(Duration pause, Runnable work) {
        time.requireStepper();
        if (closed) {
            return () -> {};
        }
        SteppedEventQueue.Entry entry = add(time.nanos() + pause.toNanos(), work);
        return () -> remove(entry);
    }

    @Override
    public ScheduledTask every(Duration first, Duration pause, Runnable work) {
        Round round = new Round(pause, work);
        round.next(first);
        return round;
    }

    private SteppedEventQueue.Entry add(long dueNanos, Runnable work) {
        SteppedEventQueue.Entry[] added = new SteppedEventQueue.Entry[1];
        added[0] = agenda.add(owner, dueNanos, () -> {
            due.remove(added[0]);
            work.run();
        });
        due.add(added[0]);
        return added[0];
    }

    private void remove(SteppedEventQueue.Entry entry) {
        agenda.remove(entry);
        due.remove(entry);
    }

    /** Something that is done again and again. */
    private final class Round implements ScheduledTask {
        private final Duration pause;
        private final Runnable work;
        private ScheduledTask begun = () -> {};
        private boolean calledOff;

        Round(Duration pause, Runnable work) {
            this.pause = pause;
            this.work = work;
        }

        void next(Duration wait) {
            begun = after(wait, this::once);
        }

        private void once() {
            try {
                work.run();
            } finally {
                if (!calledOff) {
                    next(pause);
                }
            }
        }

        @Override
        public void cancel() {
            calledOff = true;
            begun.cancel();
        }
    }

    @Override
    public Duration busyFor() {
        return Duration.ZERO;
    }

    @Override
    public int waiting() {
        return waiting;
    }

    @Override
    public boolean finish(Duration longest) {
        closed = true;
        time.settle();
        close();
        return waiting == 0;
    }

    @Override
    public void close() {
        closed = true;
        Set.copyOf(due).forEach(this::remove);
    }
}
