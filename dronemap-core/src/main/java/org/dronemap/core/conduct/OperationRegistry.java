package org.dronemap.core.conduct;

import java.time.Instant;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.SavedOperation;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * In-memory registry of the operations under way (mission runs and follows). Read by any thread, changed by the
 * conductor's.
 */
final class OperationRegistry {
    private static final Logger LOG = LoggerFactory.getLogger(OperationRegistry.class);

    /** As often as that it may fail at the same turn before it is set aside; it tries ten times a second. */
    private static final int MOST_FAULTS = 10;

    private final OperationExecution.Context means;
    private final FaultedOperations aside;
    private final Supplier<Stream<DroneId>> drones;
    private final Map<String, OperationKind<?, ?>> kinds = new HashMap<>();
    private final ConcurrentHashMap<OperationId, OperationExecution<?, ?>> conducted = new ConcurrentHashMap<>();
    private final ConcurrentHashMap<OperationId, String> troubles = new ConcurrentHashMap<>();
    /** How often each failed by a fault of its own, one turn after the other. Owned by the thread. */
    private final Map<OperationId, Integer> faults = new HashMap<>();

    /** Whoever asked was told that these did not begin; they may be stored all the same. Owned by the thread. */
    private final Set<OperationId> neverBegun = new HashSet<>();

    private final LongAdder failed = new LongAdder();

    /** {@code drones}: all that there are. */
    OperationRegistry(
            OperationExecution.Context means,
            FaultedOperations aside,
            Collection<OperationKind<?, ?>> kinds,
            Supplier<Stream<DroneId>> drones) {
        this.means = means;
        this.aside = aside;
        this.drones = drones;
        kinds.forEach(kind -> this.kinds.put(kind.name(), kind));
    }

    Set<String> kinds() {
        return Set.copyOf(kinds.keySet());
    }

    /** One that cannot be read must not keep the server, and so all other drones, from being conducted. */
    void restore() {
        for (SavedOperation saved : means.store().underWay()) {
            OperationKind<?, ?> kind = kinds.get(saved.kind());
            try {
                if (kind == null) {
                    throw new IllegalArgumentException("nobody conducts operations of the kind " + saved.kind());
                }
                if (aside.isAside(saved)) {
                    aside.add(saved, "It was set aside before.", drones.get());
                    continue;
                }
                OperationExecution<?, ?> one = read(kind, saved);
                conducted.put(saved.id(), one);
                one.restore();
            } catch (IllegalArgumentException unreadable) {
                failed.increment();
                LOG.error("The operation {} cannot be taken up again", saved.id(), unreadable);
                aside.add(saved, "It cannot be taken up again: " + unreadable.getMessage(), drones.get());
            }
        }
    }

    /** Takes up none. */
    void setAside(String why) {
        means.store().underWay().forEach(saved -> aside.add(saved, why, drones.get()));
    }

    FaultedOperations aside() {
        return aside;
    }

    void goOn() {
        conducted.values().forEach(OperationExecution::resumeOnceConnected);
    }

    private <S, I> OperationExecution<S, I> read(OperationKind<S, I> kind, SavedOperation saved) {
        return new OperationExecution<>(kind, means, saved, kind.codec().state(saved.state()));
    }

    <S, I> OperationExecution<S, I> begin(OperationKind<S, I> kind, SavedOperation begun, JournalEntry first, S state) {
        if (!kind.equals(kinds.get(kind.name()))) {
            // After a restart nobody could read what was written of it.
            LOG.error("A fault of ours: nobody conducts operations of the kind {}; none is begun", kind.name());
            throw new Operations.Refused(Objection.of(
                    OperationObjection.NOT_CONDUCTED,
                    "The cloud does not conduct operations of the kind " + kind.name()
                            + ": a fault of its own, which is logged for its makers."));
        }
        SavedOperation saved = begun.beginning(first.input());
        OperationExecution<S, I> one = new OperationExecution<>(kind, means, saved, state);
        one.acquireLeases().ifPresent(why -> {
            throw why;
        });
        try {
            means.store().begin(saved, first);
        } catch (RuntimeException e) {
            one.releaseLeases();
            neverBegun.add(saved.id());
            throw e;
        }
        conducted.put(saved.id(), one);
        means.listener().changed(saved, "");
        return one;
    }

    <S, I> Optional<OperationExecution<S, I>> find(OperationKind<S, I> kind, OperationId id) {
        return Optional.ofNullable(conducted.get(id)).flatMap(one -> ofKind(kind, one));
    }

    /** The oldest first. */
    <S, I> List<OperationExecution<S, I>> all(OperationKind<S, I> kind) {
        return inOrder().stream().flatMap(one -> ofKind(kind, one).stream()).toList();
    }

    /** Kinds are as good as their names: there is one of each. */
    @SuppressWarnings("unchecked")
    private static <S, I> Optional<OperationExecution<S, I>> ofKind(
            OperationKind<S, I> kind, OperationExecution<?, ?> one) {
        return one.kind().name().equals(kind.name()) ? Optional.of((OperationExecution<S, I>) one) : Optional.empty();
    }

    private List<OperationExecution<?, ?>> inOrder() {
        return conducted.values().stream()
                .sorted(Comparator.<OperationExecution<?, ?>, Instant>comparing(
                                one -> one.now().saved().beganAt())
                        .thenComparing(one -> one.now().saved().id().value()))
                .toList();
    }

    /** One that cannot be conducted must not keep the others from it. */
    void turn() {
        forgetNeverBegun();
        for (OperationExecution<?, ?> one : inOrder()) {
            OperationId id = one.now().saved().id();
            try {
                one.turn();
                troubles.remove(id);
                faults.remove(id);
            } catch (OperationExecution.MachineFault e) {
                failed.increment();
                if (faults.merge(id, 1, Integer::sum) >= MOST_FAULTS) {
                    setAside(one, e);
                }
            } catch (RuntimeException e) {
                failed.increment();
                String trouble = "“" + one.now().saved().name() + "” does not go on: " + e.getMessage();
                if (!trouble.equals(troubles.put(id, trouble))) {
                    LOG.error("Conducting {} failed; it is tried again", id, e);
                }
            }
        }
        aside.turn();
        tidy();
    }

    /** What it cannot decide now it cannot decide ever, and its drones wait for it in the air. */
    private void setAside(OperationExecution<?, ?> one, OperationExecution.MachineFault fault) {
        OperationId id = one.now().saved().id();
        LOG.error("Conducting {} fails again and again", id, fault);
        aside.add(one.now().saved(), "It cannot go on: " + fault.getMessage(), drones.get());
        one.cancelComputations();
        one.forgetIntents();
        conducted.remove(id);
        faults.remove(id);
        troubles.remove(id);
    }

    private void forgetNeverBegun() {
        for (OperationId id : List.copyOf(neverBegun)) {
            try {
                means.store().forget(id);
                neverBegun.remove(id);
            } catch (RuntimeException e) {
                LOG.debug("Whether {} is stored is not known yet", id, e);
            }
        }
    }

    /** What is over is found in the store. */
    void tidy() {
        conducted.values().removeIf(OperationExecution::isOver);
    }

    void interrupted(DroneId drone) {
        conducted.values().forEach(one -> one.interrupted(drone));
    }

    long failedCount() {
        return failed.sum();
    }

    List<String> troubles() {
        return Stream.concat(
                        troubles.values().stream(),
                        aside.reasons().entrySet().stream()
                                .map(one -> "The operation " + one.getKey() + " is set aside. " + one.getValue()))
                .toList();
    }
}
