package org.dronemap.core.time;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/** A {@link Loop} in stepped (simulated) time. */
final class SteppedLoop implements Loop {
    private final SteppedProcess time;
    private final SteppedEventQueue agenda;
    private final SteppedEventQueue.Owner owner;
    private final Turn turn;
    private SteppedEventQueue.@Nullable Entry next;
    private boolean taking;
    private boolean woken;
    private boolean closed;

    SteppedLoop(
            SteppedProcess time, SteppedEventQueue agenda, SteppedEventQueue.Lifetime life, String name, Turn turn) {
        this.time = time;
        this.agenda = agenda;
        this.owner = new SteppedEventQueue.Owner(name, life);
        this.turn = turn;
    }

    @Override
    public void start() {
        schedule(0);
    }

    @Override
    public void wake() {
        time.requireStepper();
        if (taking) {
            woken = true;
        } else if (next != null && next.dueNanos() > time.nanos()) {
            agenda.remove(next);
            schedule(0);
        }
    }

    private void schedule(long restNanos) {
        next = closed ? null : agenda.add(owner, time.nanos() + restNanos, this::runTurn);
    }

    private void runTurn() {
        long rest = Duration.ofMillis(100).toNanos();
        woken = false;
        taking = true;
        try {
            rest = turn.run();
        } finally {
            taking = false;
            schedule(woken ? 0 : rest);
        }
    }

    @Override
    public void close() {
        closed = true;
        if (next != null) {
            agenda.remove(next);
            next = null;
        }
    }

    @Override
    public boolean finish(Duration longest) {
        close();
        long unused = turn.run();
        return true;
    }
}
