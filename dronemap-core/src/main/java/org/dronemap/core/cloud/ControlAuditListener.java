package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.Map;
import java.util.function.Function;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditStore;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.organisation.OrganisationId;

/**
 * Writes audit records of control changes that no call caused: expiry, a pilot at the vehicle, rights that end. Any
 * thread.
 */
public final class ControlAuditListener implements CloudListener {
    private static final String FACE = "rule";
    private static final String SERVER = "dronemap";

    /** Of the others the call tells that asked for them. */
    private static final Map<ControlChange.Kind, String> UNASKED = Map.of(
            ControlChange.Kind.EXPIRED, "controlExpired",
            ControlChange.Kind.LOST, "controlLost",
            ControlChange.Kind.RETURN_DUE, "returnDue",
            ControlChange.Kind.PILOT_ACTED, "pilotActed",
            ControlChange.Kind.PILOT_LEFT, "pilotLeft",
            ControlChange.Kind.EXPELLED, "controlWithdrawn");

    private final AuditStore audit;
    private final Clock clock;
    private final Function<DroneId, OrganisationId> owners;

    public ControlAuditListener(AuditStore audit, Clock clock, Function<DroneId, OrganisationId> owners) {
        this.audit = audit;
        this.clock = clock;
        this.owners = owners;
    }

    @Override
    public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
        String operation = UNASKED.get(change.kind());
        if (operation != null) {
            // A lane must not wait for a disk.
            audit.appendLater(new AuditEntry(
                    clock.instant(),
                    SERVER,
                    owners.apply(drone).value(),
                    null,
                    FACE,
                    operation,
                    drone.value(),
                    now.epoch() == 0 ? null : (Long) now.epoch(),
                    null,
                    (change.other() == null ? change.by() : change.other()).words(),
                    AuditOutcome.SUCCEEDED,
                    change.reason(),
                    null,
                    null));
        }
    }
}
