package org.dronemap.core.cloud;

import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.drone.DroneId;

/** Which commands need no control of the drone. */
final class ControlRules {
    private ControlRules() {}

    /** Asks the vehicle, and changes nothing. */
    static boolean onlyReads(Command command) {
        return command instanceof Command.ReadHome
                || command instanceof Command.ReadParameters
                || command instanceof Command.ReadLogs
                || command instanceof Command.DownloadLog
                || command instanceof Command.ReadFence
                || command instanceof Command.ReadRallyPoints
                || command instanceof ReadMap;
    }

    /** What must work even when nothing can be written. */
    static boolean bringsToSafety(Command command) {
        return command instanceof Command.Land
                || command instanceof Command.ReturnToLaunch
                || command instanceof EmergencyStop
                || command instanceof Command.Hold;
    }

    /** Whoever answers for safety stops, lands and calls back whatever others fly. */
    static boolean isOpenTo(Principal principal, DroneId drone, Command command) {
        return principal.may(Role.SUPERVISOR, drone)
                && (bringsToSafety(command) || command instanceof Command.PauseMission);
    }
}
