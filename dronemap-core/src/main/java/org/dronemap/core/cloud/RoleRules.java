package org.dronemap.core.cloud;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;

/** Which kinds of commands a role may give; the same sentences serve the gate and every page that greys a button. */
public final class RoleRules {
    private static final String MAY_NOT_COMMAND =
            "Your role may look, not command; ask an administrator for the operator role.";
    private static final String MAY_ONLY_PLAN =
            "Your role may plan, not fly; ask an administrator for the operator role.";
    private static final String ONLY_ON_THE_GROUND =
            "A planner may change what a drone carries only while it is known to be disarmed.";

    /** What prepares a flight and moves nothing. */
    private static final Set<Capability> PLANNING =
            EnumSet.of(Capability.UPLOAD_MISSION, Capability.CLEAR_MISSION, Capability.FENCE, Capability.RALLY_POINTS);

    private RoleRules() {}

    /** Why this role may not give a command of this kind to that drone now; empty when it may. */
    public static Optional<String> whyNot(Role role, DroneState drone, Capability capability) {
        if (role.includes(Role.OPERATOR)) {
            return Optional.empty();
        }
        if (!role.includes(Role.PLANNER)) {
            return Optional.of(MAY_NOT_COMMAND);
        }
        if (!PLANNING.contains(capability)) {
            return Optional.of(MAY_ONLY_PLAN);
        }
        // A drone in AUTO may be flying the very mission that is overwritten.
        return Boolean.FALSE.equals(drone.armed()) ? Optional.empty() : Optional.of(ONLY_ON_THE_GROUND);
    }
}
