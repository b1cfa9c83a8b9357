package org.dronemap.core.cloud;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.IdentityTrust;
import org.jspecify.annotations.Nullable;

/**
 * Decides which drone a new session speaks for: proof counts at once, hardware id and address only when unclaimed.
 * Proof (a link or signature of its own) is believed at once; a hardware id or an address only when nobody else speaks
 * for that drone, and never for one that has shown proof before. Any thread.
 */
final class IdentityResolver {
    /** So long must a drone have been silent before another address may be it without proof. */
    private static final long SILENT_NANOS = 1_500_000_000L;
    /** What was under way from an address that was just left may still arrive for so long. */
    private static final long UNDER_WAY_NANOS = 1_000_000_000L;

    private final DroneRegistry registry;

    IdentityResolver(DroneRegistry registry) {
        this.registry = registry;
    }

    ClaimDecision judge(Claim claim) {
        if (claim.proof() instanceof IdentityProof.OfSignature signature) {
            Optional<ManagedDrone> owner = registry.find(signature.drone());
            if (owner.isPresent()) {
                return proved(owner.get(), claim);
            }
        }
        if (claim.proof() instanceof IdentityProof.OfLink link && link.drone() != null) {
            // It is that drone or none: where it speaks from makes it no other one.
            return registry.find(link.drone())
                    .map(owner -> proved(owner, claim))
                    .orElseGet(ClaimDecision.NewVehicle::new);
        }
        ClaimDecision unproved = unproved(claim);
        if (claim.proof() instanceof IdentityProof.OfLink link) {
            return registry.ofLinkIdentity(link.identity())
                    .map(owner -> proved(owner, claim))
                    .orElse(unproved instanceof ClaimDecision.Known ? unproved : new ClaimDecision.NewVehicle());
        }
        return unproved;
    }

    /** One key in two vehicles makes no one vehicle of them. */
    private static ClaimDecision proved(ManagedDrone drone, Claim claim) {
        DroneState state = drone.drone().state();
        boolean same = state.link().key().systemId() == claim.session().key().systemId()
                && state.identification()
                        .vehicle()
                        .equals(claim.identification().vehicle());
        return same || drone.silenceNanos() >= SILENT_NANOS
                ? new ClaimDecision.Known(drone)
                : apart(
                        drone.id(),
                        "It shows the key of " + name(drone) + ", which is heard from elsewhere and is another vehicle."
                                + " Each vehicle needs a key of its own.");
    }

    private ClaimDecision unproved(Claim claim) {
        DroneKey key = claim.session().key();
        String uid = claim.identification().hardwareUid();
        Optional<ManagedDrone> sameAddress = registry.at(key, uid);
        List<ManagedDrone> sameHardware = registry.ofHardware(uid);
        boolean distinct = sameAddress.isPresent()
                && sameAddress.get().drone().state().standing().distinct();
        // An id that several drones have is the id of none.
        if (!distinct && sameHardware.size() == 1 && !sameHardware.get(0).speaksFrom(key)) {
            return hardware(sameHardware.get(0), claim);
        }
        return sameAddress
                .map(drone -> provedBefore(drone, claim).orElse(new ClaimDecision.Known(drone)))
                .orElse(new ClaimDecision.NewVehicle());
    }

    private static ClaimDecision hardware(ManagedDrone drone, Claim claim) {
        Optional<ClaimDecision> proved = provedBefore(drone, claim);
        if (proved.isPresent()) {
            return proved.get();
        }
        long silence = drone.silenceNanos();
        if (silence >= SILENT_NANOS) {
            return new ClaimDecision.Known(drone);
        }
        if (silence < claim.ageNanos() - UNDER_WAY_NANOS) {
            return apart(drone.id(), "It says that it is " + name(drone) + ", which is heard from elsewhere.");
        }
        return apart(null, "It may be " + name(drone) + " at a new address; that shows when the old one falls silent.");
    }

    /** A drone that has shown a proof is not had for less; who has the key of another vehicle is another vehicle. */
    private static Optional<ClaimDecision> provedBefore(ManagedDrone drone, Claim claim) {
        IdentityTrust standing = drone.drone().state().standing();
        String identity = standing.linkIdentity();
        if (standing.strongest().isProof() && claim.proof() == null) {
            return Optional.of(apart(
                    drone.id(),
                    "It says that it is " + name(drone) + ", which has shown proof before; this one shows none."));
        }
        boolean another = claim.proof() instanceof IdentityProof.OfLink link
                && identity != null
                && !identity.equals(link.identity());
        return another ? Optional.of(new ClaimDecision.NewVehicle()) : Optional.empty();
    }

    private static ClaimDecision apart(@Nullable DroneId claims, String why) {
        return new ClaimDecision.Quarantined(claims, why);
    }

    private static String name(ManagedDrone drone) {
        return drone.drone().state().name();
    }
}
