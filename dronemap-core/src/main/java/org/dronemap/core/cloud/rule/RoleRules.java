package org.dronemap.core.cloud.rule;

import java.util.Optional;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;

/** Rules for which kinds of commands each user role may give. */
public final class RoleRules {
    private static final Refusal MAY_NOT_COMMAND = new Refusal(
            OutcomeCode.ROLE_MAY_NOT_COMMAND,
            "Your role may look, not command; ask an administrator for the operator role.");
    private static final Refusal MAY_ONLY_PLAN = new Refusal(
            OutcomeCode.ROLE_MAY_NOT_COMMAND,
            "Your role may plan, not fly; ask an administrator for the operator role.");
    private static final Refusal ONLY_ON_THE_GROUND = new Refusal(
            OutcomeCode.NOT_DISARMED_FOR_PLANNER,
            "A planner may change what a drone carries only while it is known to be disarmed.");

    private static final Refusal OTHER_DRONES =
            new Refusal(OutcomeCode.DRONE_NOT_OF_KEY, "This access key is for other drones.");
    private static final Refusal NOT_GRANTED_AT_ALL =
            new Refusal(OutcomeCode.COMMAND_NOT_GRANTED, "This drone is not among those that you were granted.");
    private static final Refusal MAY_NOT_PLAN_WITH_IT = new Refusal(
            OutcomeCode.COMMAND_NOT_GRANTED,
            "You were not granted to change missions, fences or rally points of this drone.");
    private static final Refusal MAY_NOT_COMMAND_IT =
            new Refusal(OutcomeCode.COMMAND_NOT_GRANTED, "You were not granted to command this drone.");
    private static final Refusal KEY_MAY_NOT_PLAN = new Refusal(
            OutcomeCode.KEY_MAY_NOT_COMMAND, "This access key may not change missions, fences or rally points.");
    private static final Refusal KEY_MAY_NOT_COMMAND =
            new Refusal(OutcomeCode.KEY_MAY_NOT_COMMAND, "This access key may not command.");

    private RoleRules() {}

    /** Why this one may not give a command of this kind to that drone now; empty when it may. */
    public static Optional<Refusal> whyNot(Principal principal, DroneState drone, Capability capability) {
        if (!principal.sees(drone.id())) {
            return Optional.of(principal.scope().covers(drone.id()) ? NOT_GRANTED_AT_ALL : OTHER_DRONES);
        }
        boolean planning = capability.part() == Capability.Part.PREPARES;
        if (!principal.may(planning ? Role.PLANNER : Role.OPERATOR, drone.id())) {
            return Optional.of(lacking(principal, planning));
        }
        // A drone in AUTO may be flying the very mission that is overwritten.
        return principal.may(Role.OPERATOR, drone.id()) || Boolean.FALSE.equals(drone.armed())
                ? Optional.empty()
                : Optional.of(ONLY_ON_THE_GROUND);
    }

    private static Refusal lacking(Principal principal, boolean planning) {
        if (principal.role().includes(planning ? Role.PLANNER : Role.OPERATOR)) {
            if (principal.scope().permissions().contains(planning ? Permission.PLAN : Permission.COMMAND)) {
                return planning ? MAY_NOT_PLAN_WITH_IT : MAY_NOT_COMMAND_IT;
            }
            return planning ? KEY_MAY_NOT_PLAN : KEY_MAY_NOT_COMMAND;
        }
        return principal.role().includes(Role.PLANNER) ? MAY_ONLY_PLAN : MAY_NOT_COMMAND;
    }
}
