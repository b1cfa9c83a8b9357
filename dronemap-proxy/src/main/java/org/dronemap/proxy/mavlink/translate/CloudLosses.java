package org.dronemap.proxy.mavlink.translate;

import java.util.Set;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ParameterChange;

/** Sets the parameter by which a copter that waits comes home, or down, when no ground station is heard any more. */
final class CloudLosses {
    private CloudLosses() {}

    /**
     * The parameter of one autopilot.
     *
     * @param stays its values by which the vehicle stays where it is
     */
    record Setting(String name, Set<Integer> stays, int comesHome, boolean bytewise) {}

    static Exchange comeHome(Cockpit cockpit, VehicleKind kind, Setting setting) {
        if (kind != VehicleKind.MULTICOPTER && kind != VehicleKind.HELICOPTER) {
            return Maneuvers.refuse("What this vehicle does when the cloud falls silent cannot be set.");
        }
        return new ParameterChange(
                cockpit.target(),
                new ParameterChange.Wanted(
                        setting.name(),
                        old -> setting.stays().contains(old) ? setting.comesHome() : old,
                        setting.bytewise()));
    }
}
