package org.dronemap.core.cloud;

/** Result that a vehicle session gets for its claim: bound to a drone, or not admitted yet. */
public sealed interface ClaimResult {
    /** It speaks for a drone. */
    record Bound(DroneLink link) implements ClaimResult {}

    /** Not yet: claim again soon; until then ask the vehicle who it is and send it nothing else. */
    record NotAdmitted(String why) implements ClaimResult {}
}
