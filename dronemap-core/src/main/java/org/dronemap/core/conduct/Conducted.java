package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.operation.Action;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.Reach;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.operation.Sighting;
import org.jspecify.annotations.Nullable;

/**
 * One operation as it is conducted: each decision is durable before anything of it happens. When it cannot be told whether
 * one is, the operation is taken up again from what is stored. Owned by the conductor's thread, but for {@link #now}.
 */
final class Conducted<S, I> {
    private final OperationKind<S, I> kind;
    private final Means means;
    private final Holder.Operation holder;
    private final Reins reins;
    private final Hands hands;
    private final @Nullable Wheel<S> wheel;
    private final List<Computations.Underway> computations = new ArrayList<>();
    /** What came to be known and was not decided on yet. */
    private final Deque<I> inbox = new ArrayDeque<>();

    private @Nullable I resumed;
    /** Bounded by what may be worked out at once. */
    private final Queue<Result<I>> results = new ConcurrentLinkedQueue<>();

    private volatile Now<S> now;
    private @Nullable SavedOperation inDoubt;
    private @Nullable I deciding;
    private long lookedNanos;

    /** What operations are conducted with; {@code wake} asks for a turn soon. */
    record Means(
            OperationStore store,
            DroneCrew crew,
            Scenery scenery,
            Computations computations,
            Clock clock,
            LongSupplier nanoTime,
            Runnable wake,
            OperationListener listener) {}

    /** As it is and as it is stored. */
    record Now<S>(SavedOperation saved, S state) {}

    /** Its kind failed at what it was given: the same will fail again. */
    static final class OwnFault extends RuntimeException {
        private static final long serialVersionUID = 1L;

        OwnFault(RuntimeException cause) {
            super(cause.toString(), cause);
        }
    }

    private record Result<I>(Object run, I input) {}

    /** What was asked to be computed belongs to one of these, and is lost with it. */
    private Object run = new Object();

    Conducted(OperationKind<S, I> kind, Means means, SavedOperation saved, S state) {
        this.kind = kind;
        this.means = means;
        this.now = new Now<>(saved, state);
        this.holder = new Holder.Operation(
                saved.id().value(), saved.owner(), kind.machine().words(state));
        this.reins = new Reins(means.crew(), holder);
        this.hands = new Hands(means.crew(), holder, means.nanoTime());
        this.wheel = kind.machine()
                .guide(state)
                .map(guide -> new Wheel<>(means.crew(), holder, guide))
                .orElse(null);
        this.lookedNanos =
                means.nanoTime().getAsLong() - kind.machine().rhythm().toNanos();
    }

    OperationKind<S, I> kind() {
        return kind;
    }

    /** Any thread. */
    Now<S> now() {
        return now;
    }

    boolean isOver() {
        return now.saved().endedAt() != null;
    }

    /** Control of all of its drones, or of none, and why. */
    Optional<Operations.NoControl> takeReins() {
        return reins.takeAll(kind.machine().drones(now.state()));
    }

    void dropReins() {
        reins.keepOnly(Set.of());
    }

    /** After a restart: what is held by somebody else is seen. */
    void takeUp() {
        reins.reachFor(wanted());
        resume();
    }

    /** Not before vehicles can be heard, however long the rest of the start took. */
    void goOn() {
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
        if (reins.wants(drone)) {
            lookedNanos -= kind.machine().rhythm().toNanos();
        }
    }

    /** Everything that is due; fails when something cannot be written down, and goes on there the next time. */
    void turn() {
        settle();
        empty();
        hearEnds();
        for (Result<I> result = results.poll(); result != null; result = results.poll()) {
            if (result.run() == run) {
                inbox.add(result.input());
            }
        }
        empty();
        long time = means.nanoTime().getAsLong();
        if (!isOver() && time - lookedNanos >= kind.machine().rhythm().toNanos()) {
            lookedNanos = time;
            look();
        }
    }

    private void empty() {
        while (!isOver() && !inbox.isEmpty()) {
            deciding = inbox.element();
            take(deciding);
            inbox.remove();
            deciding = null;
        }
    }

    private void look() {
        S state = now.state();
        Set<DroneId> drones = new HashSet<>(kind.machine().drones(state));
        drones.addAll(kind.machine().watched(state));
        SavedOperation saved = now.saved();
        Scene scene = means.scenery().of(saved, reins, drones);
        Scene seen = wheel == null ? scene : wheel.turn(state, means.scenery().around(saved, scene, drones));
        take(own(() -> kind.machine().looked(state, seen)));
    }

    private void hearEnds() {
        for (SavedOperation.Given given : now.saved().given()) {
            if (isOver() || !now.saved().given().contains(given)) {
                continue;
            }
            Optional<Outcome> end = hands.end(given);
            if (end.isPresent()) {
                take(
                        kind.machine()
                                .ended(
                                        given.drone(),
                                        given.command(),
                                        end.get(),
                                        means.clock().instant()),
                        given);
                hands.told(given);
            }
        }
    }

    /** Any thread. */
    Reception sighted(Sighting sighting) {
        return wheel == null ? Reception.UNHEARD : wheel.sighted(sighting);
    }

    /** Any thread. */
    void reached(Reach how) {
        if (wheel != null) {
            wheel.reached(how);
        }
    }

    /** Any thread. */
    Optional<Reach> reach() {
        return Optional.ofNullable(wheel).map(Wheel::reach);
    }

    /** Any thread. */
    Optional<Sighting> sighting() {
        return Optional.ofNullable(wheel).map(Wheel::newest);
    }

    /** A user's wish; why it is not taken. */
    Optional<Objection> wish(I input) {
        settle();
        if (isOver()) {
            return Optional.of(Objection.of(OperationObjection.OVER, "It is over."));
        }
        Optional<Objection> why = kind.machine().refusal(now.state(), input);
        if (why.isEmpty()) {
            take(input);
        }
        return why;
    }

    private static <T> T own(Supplier<T> work) {
        try {
            return work.get();
        } catch (RuntimeException e) {
            throw new OwnFault(e);
        }
    }

    private void take(I input) {
        take(input, null);
    }

    private void take(I input, SavedOperation.@Nullable Given ended) {
        S before = now.state();
        Decision<S, I> decision = own(() -> kind.machine().decide(before, input));
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
        carryOut(new Now<>(next, decision.next()), decision);
    }

    /** It is not written down that its end was heard: after a restart it is heard again, and changes as little. */
    private void forget(SavedOperation.@Nullable Given ended) {
        if (ended != null) {
            SavedOperation saved = now.saved();
            List<SavedOperation.Given> open = new ArrayList<>(saved.given());
            open.remove(ended);
            now = new Now<>(saved.with(open), now.state());
        }
    }

    private SavedOperation next(Decision<S, I> decision, SavedOperation.@Nullable Given ended) {
        List<SavedOperation.Given> open = new ArrayList<>(now.saved().given());
        open.remove(ended);
        for (Action<I> action : decision.actions()) {
            if (action instanceof Action.Give<I> give) {
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

    private void carryOut(Now<S> next, Decision<S, I> decision) {
        now = next;
        reins.reachFor(wanted());
        for (Action<I> action : decision.actions()) {
            if (action instanceof Action.Give<I> give) {
                hands.give(give);
            } else if (action instanceof Action.Compute<I> compute) {
                compute(compute);
            }
        }
        reins.keepOnly(wanted());
        if (isOver()) {
            callOff();
        }
        means.listener().changed(next.saved(), decision.why() == null ? "" : decision.why());
    }

    private void compute(Action.Compute<I> compute) {
        Object asked = run;
        computations.add(means.computations().run(compute.what(), input -> {
            results.add(new Result<>(asked, input));
            means.wake().run();
        }));
    }

    /** Nobody waits for what is being worked out any more. */
    void callOff() {
        computations.forEach(Computations.Underway::callOff);
        computations.clear();
        run = new Object();
    }

    private Set<DroneId> wanted() {
        return isOver() ? Set.of() : kind.machine().drones(now.state());
    }

    /** Finds out whether the last decision is stored although that seemed to fail. */
    private void settle() {
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
        callOff();
        now = new Now<>(stored, kind.codec().state(stored.state()));
        reins.reachFor(wanted());
        reins.keepOnly(wanted());
        resume();
        means.listener().changed(stored, "");
    }
}
