package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.SavedOperation;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Operations set aside as running them failed, or may have crashed the server; sends their drones home. Their states
 * are not read. Each of their drones that is heard goes home unless somebody else has it; when all have gone, or at the
 * latest after {@link #LONGEST}, the operation is over. Owned by the conductor's thread, but for what is asked.
 */
final class FaultedOperations {
    private static final Logger LOG = LoggerFactory.getLogger(FaultedOperations.class);
    /** Whoever was silent for so long flies no more. */
    static final Duration LONGEST = Duration.ofHours(1);

    private static final String WORDS = "An operation that was set aside";

    private final OperationExecution.Context means;
    private final ReturnCommander wayHome;
    private final Function<DroneId, Optional<DroneState>> drones;
    private final Clock clock;
    private final Map<OperationId, FaultedOperation> asides = new ConcurrentHashMap<>();

    /** {@code left}: drones that are not on their way home yet. Owned by the thread. */
    private record FaultedOperation(SavedOperation saved, String why, Instant since, Set<DroneId> left) {
        LeaseHolder.Operation holder() {
            return new LeaseHolder.Operation(saved.id().value(), saved.owner(), WORDS);
        }
    }

    FaultedOperations(
            OperationExecution.Context means, ReturnCommander wayHome, Function<DroneId, Optional<DroneState>> drones) {
        this.means = means;
        this.wayHome = wayHome;
        this.drones = drones;
        this.clock = means.clock();
    }

    /** Whether that is the newest that is written down of it. */
    boolean isAside(SavedOperation saved) {
        return means.store().journal(saved.id(), saved.last(), 1).stream().anyMatch(JournalEntry::setsAside);
    }

    /** Writes down that it is, unless it is known, and takes control of its drones; {@code known}: all that there are. */
    void add(SavedOperation saved, String why, Stream<DroneId> known) {
        SavedOperation now = saved;
        if (!isAside(saved)) {
            now = saved.next(saved.state(), List.of(), null);
            means.store().append(now, JournalEntry.settingAside(now.last(), clock.instant(), why));
        }
        Set<DroneId> its = new HashSet<>(named(saved, known));
        FaultedOperation aside = new FaultedOperation(now, why, clock.instant(), its);
        its.removeIf(drone -> means.crew().engage(aside.holder(), drone).isPresent());
        asides.put(saved.id(), aside);
        LOG.error("The operation {} is set aside, and {} go home: {}", saved.id(), its, why);
        means.listener().changed(now, why);
    }

    /** Reading the state may be what fails; ids of drones are like no other word of it. */
    private static List<DroneId> named(SavedOperation saved, Stream<DroneId> known) {
        Set<DroneId> given = new HashSet<>(
                saved.given().stream().map(SavedOperation.Given::drone).toList());
        return known.filter(drone -> given.contains(drone) || isIn(saved.state(), drone))
                .toList();
    }

    private static boolean isIn(String state, DroneId drone) {
        return Pattern.compile("(?<![\\w-])" + Pattern.quote(drone.value()) + "(?![\\w-])")
                .matcher(state)
                .find();
    }

    void turn() {
        for (FaultedOperation aside : List.copyOf(asides.values())) {
            aside.left().removeIf(drone -> isDone(aside, drone));
            boolean late = Duration.between(aside.since(), clock.instant()).compareTo(LONGEST) > 0;
            if (aside.left().isEmpty() || late) {
                end(aside);
            }
        }
    }

    private boolean isDone(FaultedOperation aside, DroneId drone) {
        Optional<DroneState> state = drones.apply(drone);
        return state.isEmpty() || wayHome.commandReturn(aside.holder(), state.get());
    }

    private void end(FaultedOperation aside) {
        aside.left().forEach(drone -> means.crew().release(aside.holder(), drone));
        SavedOperation over = aside.saved().next(aside.saved().state(), List.of(), clock.instant());
        means.store().append(over, JournalEntry.settingAside(over.last(), clock.instant(), "It is over."));
        asides.remove(aside.saved().id());
        means.listener().changed(over, aside.why());
    }

    /** Why they are, by the operation. Any thread. */
    Map<OperationId, String> reasons() {
        Map<OperationId, String> reasons = new LinkedHashMap<>();
        asides.forEach((id, aside) -> reasons.put(id, aside.why()));
        return reasons;
    }

    /** Those of a kind. Any thread. */
    List<SavedOperation> ofKind(String kind) {
        return asides.values().stream()
                .map(FaultedOperation::saved)
                .filter(saved -> saved.kind().equals(kind))
                .toList();
    }

    /** Any thread. */
    Optional<SavedOperation> find(OperationId id) {
        return Optional.ofNullable(asides.get(id)).map(FaultedOperation::saved);
    }
}
