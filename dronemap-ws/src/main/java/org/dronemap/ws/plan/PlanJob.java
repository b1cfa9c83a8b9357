package org.dronemap.ws.plan;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.engine.SearchProgress;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * One plan for several drones, from the request through the search to acceptance and start of its flights. Any thread.
 */
public final class PlanJob {
    /** Older ones are thinned out: a picture needs no more. */
    private static final int MOST_STEPS = 200;

    private final String id;
    private final String owner;
    private final String account;
    private final OrganisationId organisation;
    private final Instant askedAt;
    private final PlanJobInput order;
    private volatile Status status = new Status(State.QUEUED, List.of(), null, null, null, false, List.of());
    /** Guarded by this: ends with why, when nobody else is to be started. */
    private CompletableFuture<DroneLaunchStatus.Reason> stopped = new CompletableFuture<>();
    /** Guarded by this: on the clock that durations are measured with. */
    private long endedNanos;

    /** State of a planning job. */
    enum State {
        QUEUED,
        RUNNING,
        FINISHED,
        CANCELLED,
        FAILED;

        boolean isUnderWay() {
            return this == QUEUED || this == RUNNING;
        }
    }

    /** A better plan, so many seconds after the search began. */
    record Step(double seconds, SearchProgress progress) {}

    /**
     * A job at one moment.
     *
     * @param orders of each drone the numbers of its waypoints, of the best plan so far; null: none yet
     * @param result null until it is finished
     * @param why it failed, as a sentence
     * @param busy whether missions are on their way to the drones, or drones are started
     */
    record Status(
            State state,
            List<Step> steps,
            @Nullable List<List<Integer>> orders,
            @Nullable PlanResult result,
            @Nullable String why,
            boolean busy,
            List<DroneLaunchStatus> flights) {
        Status to(State other) {
            return new Status(other, steps, orders, result, why, busy, flights);
        }

        Status with(boolean isBusy, List<DroneLaunchStatus> now) {
            return new Status(state, steps, orders, result, why, isBusy, List.copyOf(now));
        }
    }

    /** Owner of a planning job, and the time of its request. */
    record Origin(String owner, String account, OrganisationId organisation, Instant askedAt) {}

    PlanJob(String id, Origin origin, PlanJobInput order) {
        this.id = id;
        this.owner = origin.owner();
        this.account = origin.account();
        this.organisation = origin.organisation();
        this.askedAt = origin.askedAt();
        this.order = order;
    }

    public String id() {
        return id;
    }

    String owner() {
        return owner;
    }

    /** Whose it is; the name of the owner is for people. */
    String account() {
        return account;
    }

    OrganisationId organisation() {
        return organisation;
    }

    Instant askedAt() {
        return askedAt;
    }

    PlanJobInput order() {
        return order;
    }

    Status status() {
        return status;
    }

    private synchronized boolean change(State from, UnaryOperator<Status> how) {
        if (status.state() != from) {
            return false;
        }
        status = how.apply(status);
        return true;
    }

    /** False when it was cancelled meanwhile. */
    boolean begin() {
        return change(State.QUEUED, now -> now.to(State.RUNNING));
    }

    boolean improve(Step step, int[][] found) {
        List<List<Integer>> orders = Arrays.stream(found)
                .map(order -> IntStream.of(order).boxed().toList())
                .toList();
        return change(State.RUNNING, now -> {
            List<Step> steps = new ArrayList<>(now.steps());
            if (steps.size() >= MOST_STEPS) {
                thin(steps);
            }
            steps.add(step);
            return new Status(now.state(), List.copyOf(steps), orders, null, null, false, List.of());
        });
    }

    private static void thin(List<Step> steps) {
        for (int i = steps.size() - 2; i > 0; i -= 2) {
            steps.remove(i);
        }
    }

    void finish(PlanResult planned, long nowNanos) {
        if (change(
                State.RUNNING,
                now -> new Status(State.FINISHED, now.steps(), now.orders(), planned, null, false, List.of()))) {
            ended(nowNanos);
        }
    }

    void fail(String why, long nowNanos) {
        if (change(
                State.RUNNING,
                now -> new Status(State.FAILED, now.steps(), now.orders(), null, why, false, List.of()))) {
            ended(nowNanos);
        }
    }

    /** False when there is nothing to be cancelled any more. */
    boolean cancel(long nowNanos) {
        boolean cancelled = change(State.QUEUED, now -> now.to(State.CANCELLED))
                || change(State.RUNNING, now -> now.to(State.CANCELLED));
        if (cancelled) {
            ended(nowNanos);
        }
        return cancelled;
    }

    boolean isCancelled() {
        return status.state() == State.CANCELLED;
    }

    private synchronized void ended(long nowNanos) {
        endedNanos = nowNanos;
    }

    /** Since when nothing happens any more by itself. */
    synchronized long endedNanos() {
        return endedNanos;
    }

    /** False when its missions are on their way already, or it is not finished. */
    synchronized boolean accept(List<DroneLaunchStatus> begun) {
        if (status.state() != State.FINISHED || status.busy()) {
            return false;
        }
        status = status.with(true, begun);
        stopped = new CompletableFuture<>();
        return true;
    }

    /** Whoever has not been started yet will not be; false when nothing is under way. */
    synchronized boolean stop(DroneLaunchStatus.Reason why) {
        return status.busy() && stopped.complete(why);
    }

    /** Ends with why nobody else is to be started, if that happens to this launch. */
    synchronized CompletableFuture<DroneLaunchStatus.Reason> stopped() {
        return stopped.copy();
    }

    /** Why nobody else is to be started; null: nothing speaks against it. */
    synchronized DroneLaunchStatus.@Nullable Reason whyStopped() {
        return stopped.getNow(null);
    }

    synchronized void settle(DroneLaunchStatus flight) {
        List<DroneLaunchStatus> flights = status.flights().stream()
                .map(one -> one.drone().equals(flight.drone()) ? flight : one)
                .toList();
        status = status.with(status.busy(), flights);
    }

    synchronized void launched(long nowNanos) {
        status = status.with(false, status.flights());
        endedNanos = nowNanos;
    }
}
