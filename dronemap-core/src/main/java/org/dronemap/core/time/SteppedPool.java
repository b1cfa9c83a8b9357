package org.dronemap.core.time;

/** In stepped time: one thing after the other. */
final class SteppedPool implements Pool {
    private final Worker worker;
    private boolean closed;

    SteppedPool(Worker worker) {
        this.worker = worker;
    }

    @Override
    public void execute(Runnable work) {
        worker.execute(work);
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
