package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunAssignment;
import org.dronemap.core.virtual.VirtualRunStage;
import org.jspecify.annotations.Nullable;

/**
 * Writes audit records of which real drone serves a virtual drone, and how that ended. Owned by the conductor's thread.
 */
public final class BindingAuditListener implements VirtualDroneListener {
    private static final String SERVER = "dronemap";

    private final AuditStore audit;
    private final Clock clock;
    /** By their shares. */
    private final Map<VirtualDroneId, List<Optional<DroneId>>> serving = new HashMap<>();

    /** {@code known}: as they are before the first change is heard of. */
    public BindingAuditListener(AuditStore audit, Clock clock, Collection<VirtualDrone> known) {
        this.audit = audit;
        this.clock = clock;
        known.forEach(drone -> serving.put(drone.id(), bound(drone)));
    }

    private static List<Optional<DroneId>> bound(VirtualDrone drone) {
        return drone.runs().stream()
                .map(run -> Optional.ofNullable(run.boundTo()))
                .toList();
    }

    @Override
    public void changed(VirtualDrone drone) {
        List<Optional<DroneId>> before = serving.getOrDefault(drone.id(), List.of());
        List<Optional<DroneId>> now = bound(drone);
        serving.put(drone.id(), now);
        for (int share = 0; share < now.size(); share++) {
            Optional<DroneId> last = share < before.size() ? before.get(share) : Optional.empty();
            if (!last.equals(now.get(share))) {
                VirtualRun run = drone.runs().get(share);
                last.ifPresent(served -> released(drone, run, served));
                now.get(share).ifPresent(served -> bound(drone, run, served));
            }
        }
    }

    private void released(VirtualDrone drone, VirtualRun run, DroneId served) {
        boolean failed = run.stage() == VirtualRunStage.FAILED || run.stage() == VirtualRunStage.QUEUED;
        append(
                drone,
                served,
                "releaseDrone",
                failed ? AuditOutcome.FAILED : AuditOutcome.SUCCEEDED,
                run.detail() == null ? run.note() : run.detail());
    }

    private void bound(VirtualDrone drone, VirtualRun run, DroneId served) {
        VirtualRunAssignment assignment = run.assignment();
        append(
                drone,
                served,
                "bindDrone",
                AuditOutcome.SUCCEEDED,
                assignment == null ? null : assignment.choice().sentence(DroneId::value));
    }

    @Override
    public void removed(VirtualDrone drone) {
        serving.remove(drone.id());
    }

    private void append(
            VirtualDrone drone, DroneId served, String operation, AuditOutcome outcome, @Nullable String why) {
        // The conductor must not wait for a disk.
        audit.appendLater(new AuditEntry(
                clock.instant(),
                SERVER,
                drone.organisation().value(),
                null,
                VirtualDrones.FACE,
                operation,
                served.value(),
                null,
                null,
                "virtual drone " + drone.id().value() + " of " + drone.owner(),
                outcome,
                why,
                null,
                null));
    }
}
