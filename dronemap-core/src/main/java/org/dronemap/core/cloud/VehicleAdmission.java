package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.Severity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Admits new vehicle sessions: binds each to its drone, or keeps it waiting for a user's decision. Thread-safe. */
final class VehicleAdmission {
    private static final Logger LOG = LoggerFactory.getLogger(VehicleAdmission.class);

    private final DroneRegistry registry;
    private final IdentityResolver recognition;
    private final WaitingVehicleRegistry room;

    VehicleAdmission(DroneRegistry registry, Clock clock) {
        this.registry = registry;
        this.recognition = new IdentityResolver(registry);
        this.room = new WaitingVehicleRegistry(clock);
    }

    /** Who does not come in is noted in the waiting room, with an alarm at the drone that it says it is. */
    ClaimDecision judge(Claim claim) {
        if (claim.session().replay()) {
            return new ClaimDecision.NewVehicle();
        }
        ClaimDecision verdict = stillQuarantined(claim).orElseGet(() -> recognition.judge(claim));
        boolean admitted = verdict instanceof ClaimDecision.Known
                || (verdict instanceof ClaimDecision.NewVehicle && (claim.trusted() || claim.proof() != null));
        if (admitted) {
            room.leave(claim.session().key());
            return verdict;
        }
        ClaimDecision.Quarantined apart = verdict instanceof ClaimDecision.Quarantined known
                ? known
                : new ClaimDecision.Quarantined(null, "Nobody knows it; an administrator may let it in.");
        if (room.note(claim, apart)) {
            raiseAlert(claim, apart);
        }
        return apart;
    }

    /** Who was seen beside the drone that it claims to be stays out until a person or a proof decides. */
    private Optional<ClaimDecision> stillQuarantined(Claim claim) {
        if (claim.proof() != null) {
            return Optional.empty();
        }
        return room.find(claim.session().key())
                .filter(waiting -> waiting.claims() != null
                        && registry.find(waiting.claims()).isPresent())
                .map(waiting -> new ClaimDecision.Quarantined(waiting.claims(), waiting.why()));
    }

    private void raiseAlert(Claim claim, ClaimDecision.Quarantined apart) {
        DroneKey key = claim.session().key();
        LOG.warn("{} ({}) is kept outside: {}", key, claim.identification().vehicle(), apart.why());
        if (apart.claims() == null) {
            return;
        }
        registry.find(apart.claims())
                .ifPresent(drone -> drone.lane()
                        .execute(() -> drone.publishMessage(
                                Severity.ALERT,
                                "Another vehicle at " + key + " says that it is this drone. It is kept in quarantine:"
                                        + " nothing that it says is believed, and no command goes to it.")));
    }

    List<WaitingVehicle> waiting() {
        return room.all();
    }

    Optional<WaitingVehicle> remove(String id) {
        return room.remove(id);
    }

    long turnedAway() {
        return room.turnedAway();
    }
}
