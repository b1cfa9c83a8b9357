package org.dronemap.core.conduct;

import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import org.dronemap.core.operation.Computation;
import org.dronemap.core.time.Pool;
import org.dronemap.core.time.Time;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs long computations of operations, such as planning, on a few threads with a bounded queue. Any thread. */
final class ComputationExecutor implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ComputationExecutor.class);

    private final Time time;
    private final Pool pool;

    ComputationExecutor(Time time, int threads, int queued) {
        this.time = time;
        pool = time.pool("computation", threads, queued);
    }

    /** Something that is worked out, until it is called off: then nobody hears of its result. */
    static final class RunningComputation {
        private volatile boolean calledOff;

        void cancel() {
            calledOff = true;
        }
    }

    /** {@code then} hears of the result once, on any thread, this one too. */
    <I> RunningComputation run(Computation<I> what, Consumer<I> then) {
        RunningComputation underway = new RunningComputation();
        try {
            pool.execute(() -> work(what, underway, then));
        } catch (RejectedExecutionException full) {
            then.accept(what.failed("Too much is being worked out already.", time.clock()));
        }
        return underway;
    }

    private <I> void work(Computation<I> what, RunningComputation underway, Consumer<I> then) {
        if (underway.calledOff) {
            return;
        }
        I result;
        try {
            result = what.run(time, () -> underway.calledOff || pool.isClosed());
        } catch (RuntimeException e) {
            LOG.error("What an operation asked for could not be worked out", e);
            result = what.failed("The server failed; those who run it find out why in its log.", time.clock());
        }
        if (!underway.calledOff && !pool.isClosed()) {
            then.accept(result);
        }
    }

    @Override
    public void close() {
        pool.close();
    }
}
