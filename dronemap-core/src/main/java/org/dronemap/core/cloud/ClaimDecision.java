package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Decision on a claim: a known drone, a new vehicle, or one kept in quarantine. */
sealed interface ClaimDecision {
    /** This drone. */
    record Known(ManagedDrone drone) implements ClaimDecision {}

    /** A vehicle that nobody knows yet. */
    record NewVehicle() implements ClaimDecision {}

    /** Kept apart: why, and the drone that it says it is (null while it is only too early to tell). */
    record Quarantined(@Nullable DroneId claims, String why) implements ClaimDecision {}
}
