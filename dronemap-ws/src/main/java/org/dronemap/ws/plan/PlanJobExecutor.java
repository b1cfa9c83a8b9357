package org.dronemap.ws.plan;

import java.time.Duration;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.time.Pool;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs planning jobs on a few threads with a bounded queue and keeps the jobs of each organisation. Any thread. */
public final class PlanJobExecutor implements AutoCloseable {
    /** Is told when a planning job changes or is removed; on any thread, so it must return at once. */
    public interface PlanListener {
        void changed(PlanJob job);

        void removed(PlanJob job);
    }

    private static final Logger LOG = LoggerFactory.getLogger(PlanJobExecutor.class);
    private static final double NANOS = 1e9;
    private static final int MOST_LAUNCHES = 10_000;

    private final Limits bounds;
    private final Time time;
    private final Pool pool;
    /** What waits here is bounded by the drones of the jobs that are kept. */
    private final Worker launches;

    private final CopyOnWriteArrayList<PlanListener> listeners = new CopyOnWriteArrayList<>();
    /** Guarded by this; the oldest first. */
    private final Map<String, RetainedJob> jobs = new LinkedHashMap<>();

    /** A job and what works it off. */
    private record RetainedJob(PlanJob job, Runnable work) {}

    /**
     * Limits on planning jobs: threads, queue length, jobs kept and under way, and how long ended ones are kept.
     *
     * @param kept of one organisation, whatever their state
     * @param underWay of one user
     * @param remembered for so long a job is kept that has ended
     */
    public record Limits(int threads, int queued, int kept, int underWay, Duration remembered) {
        /** Leaves a core to what flies. */
        public static Limits of(int cores) {
            return new Limits(Math.max(1, Math.min(4, cores / 2)), 16, 50, 3, Duration.ofHours(1));
        }
    }

    public PlanJobExecutor(Limits bounds, Time time) {
        this.bounds = bounds;
        this.time = time;
        pool = time.pool("planner", bounds.threads(), bounds.queued());
        launches = time.worker("plan-launches", MOST_LAUNCHES);
    }

    /** Where commands of accepted plans are given: never on a thread that drones wait for. */
    Executor launches() {
        return launches;
    }

    public void addListener(PlanListener listener) {
        listeners.add(listener);
    }

    /** Queues a job, or refuses it with a sentence. */
    void submit(PlanJob job) {
        tidy();
        Optional<PlanJob> oldest;
        synchronized (this) {
            requireFewUnderWay(job.account());
            oldest = toMakeRoom(job.organisation());
            RetainedJob kept = new RetainedJob(job, () -> work(job));
            try {
                pool.execute(kept.work());
            } catch (RejectedExecutionException full) {
                throw Rejection.of(
                        ServerProblem.SERVER_BUSY,
                        bounds.queued() + " plans wait to be worked out already; try again in a minute.",
                        ProblemParameter.WHAT.is("plans"));
            }
            jobs.put(job.id(), kept);
            oldest.ifPresent(one -> jobs.remove(one.id()));
        }
        oldest.ifPresent(this::notifyRemoved);
        notifyChanged(job);
    }

    private void requireFewUnderWay(String account) {
        long underWay = all().stream()
                .filter(one ->
                        one.account().equals(account) && one.status().state().isUnderWay())
                .count();
        if (underWay >= bounds.underWay()) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "You have " + underWay + " plans under way already; wait for one of them, or cancel it.",
                    ProblemParameter.WHAT.is("plans"),
                    ProblemParameter.MOST.is(bounds.underWay()));
        }
    }

    /** The one that goes when another one comes; empty while there is room. */
    private Optional<PlanJob> toMakeRoom(OrganisationId organisation) {
        List<PlanJob> same = all().stream()
                .filter(one -> one.organisation().equals(organisation))
                .toList();
        if (same.size() < bounds.kept()) {
            return Optional.empty();
        }
        Optional<PlanJob> oldest =
                same.stream().filter(PlanJobExecutor::isOver).min(Comparator.comparingLong(PlanJob::endedNanos));
        if (oldest.isEmpty()) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "Your organisation has " + same.size() + " plans under way already; wait for one of them.",
                    ProblemParameter.WHAT.is("plans"),
                    ProblemParameter.MOST.is(bounds.kept()));
        }
        return oldest;
    }

    private static boolean isOver(PlanJob job) {
        PlanJob.Status status = job.status();
        return !status.state().isUnderWay() && !status.busy();
    }

    private void tidy() {
        List<PlanJob> old;
        synchronized (this) {
            long now = time.nanos();
            old = all().stream()
                    .filter(job -> isOver(job)
                            && now - job.endedNanos() > bounds.remembered().toNanos())
                    .toList();
            old.forEach(job -> jobs.remove(job.id()));
        }
        old.forEach(this::notifyRemoved);
    }

    private List<PlanJob> all() {
        return jobs.values().stream().map(RetainedJob::job).toList();
    }

    /** Those of an organisation, the oldest first. */
    List<PlanJob> jobs(OrganisationId organisation) {
        tidy();
        return everybodys().stream()
                .filter(job -> job.organisation().equals(organisation))
                .toList();
    }

    public synchronized Optional<PlanJob> find(String id) {
        return Optional.ofNullable(jobs.get(id)).map(RetainedJob::job);
    }

    /** Everybody's, for who shows them. */
    public synchronized List<PlanJob> everybodys() {
        return all();
    }

    /** Cancels what is under way; forgets what has ended. */
    void remove(PlanJob job) {
        if (job.cancel(time.nanos())) {
            kept(job).ifPresent(kept -> pool.remove(kept.work()));
            notifyChanged(job);
            return;
        }
        synchronized (this) {
            jobs.remove(job.id());
        }
        notifyRemoved(job);
    }

    private synchronized Optional<RetainedJob> kept(PlanJob job) {
        return Optional.ofNullable(jobs.get(job.id()));
    }

    /** Something about it has changed. */
    void notifyChanged(PlanJob job) {
        listeners.forEach(listener -> listener.changed(job));
    }

    private void notifyRemoved(PlanJob job) {
        listeners.forEach(listener -> listener.removed(job));
    }

    Time time() {
        return time;
    }

    long nowNanos() {
        return time.nanos();
    }

    private void work(PlanJob job) {
        if (!job.begin()) {
            return;
        }
        notifyChanged(job);
        PlanJobInput order = job.order();
        long began = time.nanos();
        try {
            SearchBudget budget =
                    SearchBudget.time(order.search(), time.effort()).orWhen(job::isCancelled);
            job.finish(
                    FleetPlanner.planObserved(order.problem(), order.seed(), budget, (progress, orders) -> {
                        double seconds = (time.nanos() - began) / NANOS;
                        if (job.improve(new PlanJob.Step(seconds, progress), orders)) {
                            notifyChanged(job);
                        }
                    }),
                    time.nanos());
        } catch (RuntimeException e) {
            LOG.error("The plan {} could not be worked out", job.id(), e);
            job.fail("The search failed; those who run the server find out why in its log.", time.nanos());
        }
        notifyChanged(job);
    }

    @Override
    public void close() {
        everybodys().forEach(job -> {
            job.cancel(time.nanos());
            job.stop(DroneLaunchStatus.Reason.of(
                    ServerProblem.NOT_AVAILABLE,
                    "It has its mission and was not started, since the server was shut down."));
        });
        pool.close();
        launches.close();
    }
}
