package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
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
    private final Map<VirtualDroneId, DroneId> serving = new HashMap<>();

    /** {@code known}: as they are before the first change is heard of. */
    public BindingAuditListener(AuditStore audit, Clock clock, Collection<VirtualDrone> known) {
        this.audit = audit;
        this.clock = clock;
        for (VirtualDrone drone : known) {
            DroneId bound = drone.boundTo();
            if (bound != null) {
                serving.put(drone.id(), bound);
            }
        }
    }

    @Override
    public void changed(VirtualDrone drone) {
        DroneId before = serving.get(drone.id());
        DroneId now = drone.boundTo();
        VirtualRun run = drone.run();
        if (run == null || (before == null ? now == null : before.equals(now))) {
            return;
        }
        if (before != null) {
            serving.remove(drone.id());
            boolean failed = run.stage() == VirtualRunStage.FAILED || run.stage() == VirtualRunStage.QUEUED;
            append(
                    drone,
                    before,
                    "releaseDrone",
                    failed ? AuditOutcome.FAILED : AuditOutcome.SUCCEEDED,
                    run.detail() == null ? run.note() : run.detail());
        }
        if (now != null) {
            serving.put(drone.id(), now);
            VirtualRunAssignment assignment = run.assignment();
            append(
                    drone,
                    now,
                    "bindDrone",
                    AuditOutcome.SUCCEEDED,
                    assignment == null ? null : assignment.choice().sentence(DroneId::value));
        }
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
