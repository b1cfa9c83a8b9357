package org.dronemap.core.time;

import java.util.HashSet;
import java.util.Set;

/** A {@link Pool} in stepped (simulated) time; runs its tasks one after the other. */
final class SteppedPool implements Pool {
    private final Worker worker;
    private final Set<Runnable> waiting = new HashSet<>();
    private boolean closed;

    SteppedPool(Worker worker) {
        this.worker = worker;
    }

    @Override
    public void execute(Runnable work) {
        worker.execute(() -> {
            if (waiting.remove(work)) {
                work.run();
            }
        });
        waiting.add(work);
    }

    @Override
    public boolean remove(Runnable work) {
        return waiting.remove(work);
    }

    @Override
    public boolean isClosed() {
        return closed;
    }

    @Override
    public void close() {
        closed = true;
        worker.close();
    }
}
