package org.dronemap.core.cloud.rule;

import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.drone.DroneId;

/** Rules for which commands need no control of the drone: reading, safety, supervisors' interventions. */
public final class ControlRules {
    private ControlRules() {}

    /** Asks the vehicle, and changes nothing. */
    public static boolean onlyReads(Command command) {
        return command.kind().purpose() == CommandKind.Purpose.READ;
    }

    /** What must work even when nothing can be written. */
    public static boolean bringsToSafety(Command command) {
        return command.kind().purpose() == CommandKind.Purpose.SAFETY;
    }

    /** Whoever answers for safety stops, lands and calls back whatever others fly. */
    public static boolean isOpenTo(Principal principal, DroneId drone, Command command) {
        return principal.may(Role.SUPERVISOR, drone) && command.kind().purpose().interrupts();
    }
}
