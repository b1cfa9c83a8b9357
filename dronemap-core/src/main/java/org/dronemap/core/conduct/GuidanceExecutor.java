package org.dronemap.core.conduct;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.AirspaceSnapshot;
import org.dronemap.core.operation.OperationGuidance;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.operation.TargetReport;
import org.jspecify.annotations.Nullable;

/**
 * Feeds target reports to one operation's guidance (a follow), and sends the setpoints it returns to the drones. Owned
 * by the conductor's thread, but for {@link #reported} and {@link #newestReport}.
 */
final class GuidanceExecutor<S> {
    /** Between two turns of the conductor some few come, or what a phone kept while it was cut off. */
    private static final int MOST_WAITING = 128;

    private static final Duration LATELY = Duration.ofSeconds(5);

    private final DroneGateway crew;
    private final LeaseHolder.Operation holder;
    private final OperationGuidance<S> guide;
    private final Queue<TargetReport> sightings = new ArrayDeque<>();
    private final Map<DroneId, String> refusals = new HashMap<>();
    private Set<DroneId> steered = Set.of();
    private @Nullable Instant lastUsefulAt;
    /** When the newest came that was of no use. */
    private @Nullable Instant lastUselessAt;

    private volatile @Nullable ReporterState reporterState;
    // This and what waits are guarded by what waits.
    private @Nullable TargetReport newestReport;

    GuidanceExecutor(DroneGateway crew, LeaseHolder.Operation holder, OperationGuidance<S> guide) {
        this.crew = crew;
        this.holder = holder;
        this.guide = guide;
    }

    /** Any thread. */
    TargetReportResult reported(TargetReport sighting) {
        synchronized (sightings) {
            TargetReport before = newestReport;
            if (before != null && sighting.number() <= before.number()) {
                return TargetReportResult.DUPLICATE;
            }
            if (sightings.size() >= MOST_WAITING) {
                return TargetReportResult.QUEUE_FULL;
            }
            sightings.add(sighting);
            newestReport = sighting;
            return TargetReportResult.ACCEPTED;
        }
    }

    /** The newest that was taken since the process began; null: none was. Any thread. */
    @Nullable
    TargetReport newestReport() {
        synchronized (sightings) {
            return newestReport;
        }
    }

    /** How whoever tells of sightings is reached from now on. Any thread. */
    void reporterStateChanged(ReporterState how) {
        reporterState = how;
    }

    /** Null: not known. Any thread. */
    @Nullable
    ReporterState reporterState() {
        return reporterState;
    }

    private List<TargetReport> drain() {
        synchronized (sightings) {
            List<TargetReport> all = List.copyOf(sightings);
            sightings.clear();
            return all;
        }
    }

    /** Tells the guide what came in, and the gate what the guide says; the scene with what became of it. */
    OperationObservation turn(S state, OperationObservation scene) {
        for (TargetReport one : drain()) {
            boolean useful = guide.reported(one);
            // What was kept while nobody could be told shows where it was, and not that it still says so.
            if (one.isFresh() && !useful) {
                lastUselessAt = one.receivedAt();
            } else if (one.isFresh()
                    && (lastUsefulAt == null || one.receivedAt().isAfter(lastUsefulAt))) {
                lastUsefulAt = one.receivedAt();
            }
        }
        ReporterState how = reporterState(scene.now());
        OperationObservation now =
                new OperationObservation(scene.now(), scene.drones(), lastUsefulAt, how, scene.airspace(), Map.of());
        Map<DroneId, Setpoint> said = guide.steer(state, now);
        refusals.clear();
        said.forEach(
                (drone, setpoint) -> crew.steer(holder, drone, setpoint).ifPresent(why -> refusals.put(drone, why)));
        stopSteering(said.keySet());
        return new OperationObservation(
                scene.now(), scene.drones(), lastUsefulAt, how, AirspaceSnapshot.NONE, refusals);
    }

    private @Nullable ReporterState reporterState(Instant now) {
        ReporterState connection = reporterState;
        boolean speaks = connection == null || connection == ReporterState.SPEAKS;
        boolean vague = lastUselessAt != null
                && lastUselessAt.plus(LATELY).isAfter(now)
                && (lastUsefulAt == null || lastUselessAt.isAfter(lastUsefulAt));
        return speaks && vague ? ReporterState.VAGUE : connection;
    }

    /** Of all others at once: they stand still. */
    void stopSteering(Set<DroneId> but) {
        Set<DroneId> others = new HashSet<>(steered);
        others.removeAll(but);
        steered = Set.copyOf(but);
        others.forEach(drone -> crew.stopSteering(holder, drone));
    }
}
