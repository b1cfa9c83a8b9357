package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.separation.SeparationBoard;
import org.jspecify.annotations.Nullable;

/**
 * Runs one operation: stores each decision before its actions are carried out. When it cannot be told whether one is,
 * the operation is taken up again from what is stored. Owned by the conductor's thread, but for {@link #now}.
 */
final class OperationExecution<S, I> {
    private final OperationKind<S, I> kind;
    private final Context means;
    private final LeaseHolder.Operation holder;
    private final OperationLeases reins;
    private final OperationCommands hands;
    private final @Nullable GuidanceExecutor<S> wheel;
    private final List<ComputationExecutor.RunningComputation> computations = new ArrayList<>();
    /** What came to be known and was not decided on yet. */
    private final Deque<I> inbox = new ArrayDeque<>();

    private @Nullable I resumed;
    /** Bounded by what may be worked out at once. */
    private final Queue<ComputationResult<I>> results = new ConcurrentLinkedQueue<>();

    private volatile Snapshot<S> now;
    private @Nullable SavedOperation inDoubt;
    private @Nullable I deciding;
    private long lookedNanos;

    /** Services that operations are conducted with; {@code wake} requests an early round. */
    record Context(
            OperationStore store,
            DroneGateway crew,
            ObservationBuilder observations,
            SeparationBoard board,
            ComputationExecutor computations,
            Clock clock,
            LongSupplier nanoTime,
            Runnable wake,
            OperationListener listener) {}

    /** As it is and as it is stored. */
    record Snapshot<S>(SavedOperation saved, S state) {}

    /** Its kind failed at what it was given: the same will fail again. */
    static final class MachineFault extends RuntimeException {
        private static final long serialVersionUID = 1L;

        MachineFault(RuntimeException cause) {
            super(cause.toString(), cause);
        }
    }

    private record ComputationResult<I>(Object run, I input) {}

    /** What was asked to be computed belongs to one of these, and is lost with it. */
    private Object run = new Object();

    OperationExecution(OperationKind<S, I> kind, Context means, SavedOperation saved, S state) {
        this.kind = kind;
        this.means = means;
        this.now = new Snapshot<>(saved, state);
        this.holder = new LeaseHolder.Operation(
                saved.id().value(), saved.owner(), kind.machine().words(state));
        this.reins = new OperationLeases(means.crew(), holder);
        this.hands = new OperationCommands(means.crew(), holder, means.nanoTime());
        this.wheel = kind.machine()
                .guidance(state)
                .map(guide -> new GuidanceExecutor<>(means.crew(), holder, guide))
                .orElse(null);
        this.lookedNanos =
                means.nanoTime().getAsLong() - kind.machine().rhythm().toNanos();
    }

    OperationKind<S, I> kind() {
        return kind;
    }

    /** Any thread. */
    Snapshot<S> now() {
        return now;
    }

    boolean isOver() {
        return now.saved().endedAt() != null;
    }

    /** Control of all of its drones, or of none, and why. */
    Optional<Operations.NoControl> acquireLeases() {
        return reins.acquireAll(kind.machine().drones(now.state()));
    }

    /** Nobody conducts it any more. */
    void forgetIntents() {
        means.board().intend(holder.id(), Map.of());
    }

    void releaseLeases() {
        forgetIntents();
        reins.retainOnly(Set.of());
    }

    /** After a restart: what is held by somebody else is seen. */
    void restore() {
        reins.acquire(wanted());
        resume();
    }

    /** Not before vehicles can be heard, however long the rest of the start took. */
    void resumeOnceConnected() {
        if (resumed != null) {
            inbox.remove(resumed);
            resume();
        }
    }

    private void resume() {
        I input = kind.machine().resumed(means.clock().instant());
        inbox.addFirst(input);
        resumed = input;
    }

    /** Looks at its next turn, however slow its rhythm is. */
    void interrupted(DroneId drone) {
        if (reins.isRequested(drone)) {
            lookedNanos -= kind.machine().rhythm().toNanos();
        }
    }

    /** Everything that is due; fails when something cannot be written down, and goes on there the next time. */
    void turn() {
        resolveDoubt();
        drainInbox();
        collectOutcomes();
        for (ComputationResult<I> result = results.poll(); result != null; result = results.poll()) {
            if (result.run() == run) {
                inbox.add(result.input());
            }
        }
        drainInbox();
        long time = means.nanoTime().getAsLong();
        if (!isOver() && time - lookedNanos >= kind.machine().rhythm().toNanos()) {
            lookedNanos = time;
            observe();
        }
    }

    private void drainInbox() {
        while (!isOver() && !inbox.isEmpty()) {
            deciding = inbox.element();
            apply(deciding);
            inbox.remove();
            deciding = null;
        }
    }

    private void observe() {
        S state = now.state();
        Set<DroneId> drones = new HashSet<>(kind.machine().drones(state));
        drones.addAll(kind.machine().watched(state));
        SavedOperation saved = now.saved();
        OperationObservation scene = means.observations().observe(saved, reins, drones);
        OperationObservation seen =
                wheel == null ? scene : wheel.turn(state, means.observations().withAirspace(saved, scene, drones));
        apply(own(() -> kind.machine().observed(state, seen)));
        publishIntents();
    }

    private void publishIntents() {
        means.board()
                .intend(
                        holder.id(),
                        isOver()
                                ? Map.of()
                                : own(() -> kind.machine()
                                        .intents(now.state(), means.clock().instant())));
    }

    private void collectOutcomes() {
        for (SavedOperation.Given given : now.saved().given()) {
            if (isOver() || !now.saved().given().contains(given)) {
                continue;
            }
            Optional<Outcome> end = hands.outcome(given);
            if (end.isPresent()) {
                apply(
                        kind.machine()
                                .ended(
                                        given.drone(),
                                        given.command(),
                                        end.get(),
                                        means.clock().instant()),
                        given);
                hands.forget(given);
            }
        }
    }

    /** Any thread. */
    TargetReportResult reported(TargetReport sighting) {
        return wheel == null ? TargetReportResult.NOT_EXPECTED : wheel.reported(sighting);
    }

    /** Any thread. */
    void reporterStateChanged(ReporterState how) {
        if (wheel != null) {
            wheel.reporterStateChanged(how);
        }
    }

    /** Any thread. */
    Optional<ReporterState> reporterState() {
        return Optional.ofNullable(wheel).map(GuidanceExecutor::reporterState);
    }

    /** Any thread. */
    Optional<TargetReport> newestReport() {
        return Optional.ofNullable(wheel).map(GuidanceExecutor::newestReport);
    }

    /** A user's wish; why it is not taken. */
    Optional<Objection> request(I input) {
        resolveDoubt();
        if (isOver()) {
            return Optional.of(Objection.of(OperationObjection.OVER, "It is over."));
        }
        Optional<Objection> why = kind.machine().refusal(now.state(), input);
        if (why.isEmpty()) {
            apply(input);
        }
        return why;
    }

    private static <T> T own(Supplier<T> work) {
        try {
            return work.get();
        } catch (RuntimeException e) {
            throw new MachineFault(e);
        }
    }

    private void apply(I input) {
        apply(input, null);
    }

    private void apply(I input, SavedOperation.@Nullable Given ended) {
        S before = now.state();
        OperationDecision<S, I> decision = own(() -> kind.machine().decide(before, input));
        if (decision.next().equals(before) && decision.actions().isEmpty()) {
            forget(ended);
            return;
        }
        JournalEntry entry = new JournalEntry(
                now.saved().last() + 1,
                means.clock().instant(),
                own(() -> kind.codec().input(input)),
                own(() -> kind.codec().decision(decision)));
        SavedOperation next = own(() -> next(decision, ended));
        inDoubt = next;
        means.store().append(next, entry);
        inDoubt = null;
        carryOut(new Snapshot<>(next, decision.next()), decision);
    }

    /** It is not written down that its end was heard: after a restart it is heard again, and changes as little. */
    private void forget(SavedOperation.@Nullable Given ended) {
        if (ended != null) {
            SavedOperation saved = now.saved();
            List<SavedOperation.Given> open = new ArrayList<>(saved.given());
            open.remove(ended);
            now = new Snapshot<>(saved.with(open), now.state());
        }
    }

    private SavedOperation next(OperationDecision<S, I> decision, SavedOperation.@Nullable Given ended) {
        List<SavedOperation.Given> open = new ArrayList<>(now.saved().given());
        open.remove(ended);
        for (OperationAction<I> action : decision.actions()) {
            if (action instanceof OperationAction.SendCommand<I> give) {
                open.add(new SavedOperation.Given(give.drone(), give.id()));
            }
        }
        boolean over = kind.machine().isOver(decision.next());
        return now.saved()
                .next(
                        kind.codec().state(decision.next()),
                        over ? List.of() : open,
                        over ? means.clock().instant() : null);
    }

    private void carryOut(Snapshot<S> next, OperationDecision<S, I> decision) {
        now = next;
        reins.acquire(wanted());
        for (OperationAction<I> action : decision.actions()) {
            if (action instanceof OperationAction.SendCommand<I> give) {
                hands.submit(give);
            } else if (action instanceof OperationAction.Compute<I> compute) {
                compute(compute);
            } else if (action instanceof OperationAction.HandOver<I> handOver) {
                reins.handOver(handOver.drone());
            }
        }
        reins.retainOnly(wanted());
        if (isOver()) {
            cancelComputations();
            publishIntents();
        }
        means.listener().changed(next.saved(), decision.why() == null ? "" : decision.why());
    }

    private void compute(OperationAction.Compute<I> compute) {
        Object asked = run;
        computations.add(means.computations().run(compute.what(), input -> {
            results.add(new ComputationResult<>(asked, input));
            means.wake().run();
        }));
    }

    /** Nobody waits for what is being worked out any more. */
    void cancelComputations() {
        computations.forEach(ComputationExecutor.RunningComputation::cancel);
        computations.clear();
        run = new Object();
    }

    private Set<DroneId> wanted() {
        return isOver() ? Set.of() : kind.machine().drones(now.state());
    }

    /** Finds out whether the last decision is stored although that seemed to fail. */
    private void resolveDoubt() {
        SavedOperation tried = inDoubt;
        I decided = deciding;
        deciding = null;
        if (tried == null) {
            return;
        }
        SavedOperation stored = means.store()
                .find(tried.id())
                .orElseThrow(() -> new IllegalStateException("The operation " + tried.id() + " is gone."));
        inDoubt = null;
        if (stored.last() == now.saved().last()) {
            return;
        }
        if (decided != null && stored.state().equals(tried.state())) {
            inbox.remove();
        }
        // Nobody carried it out: its commands end as never sent, and what it wanted computed is lost.
        cancelComputations();
        now = new Snapshot<>(stored, kind.codec().state(stored.state()));
        reins.acquire(wanted());
        reins.retainOnly(wanted());
        resume();
        means.listener().changed(stored, "");
    }
}
