package org.dronemap.ws.house;

import java.util.List;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.geo.Geodetic;

/** A willing copter that stands where simulated ones do, acts while a gate is open, and is down and disarmed once it was told to land or to come home. */
public final class ObedientCopter {
    private final CloudManager cloud;
    private final WillingCopter copter;
    private int seen;

    public ObedientCopter(CloudManager cloud, int port, String name, Gate gate) {
        this.cloud = cloud;
        copter = new WillingCopter(
                        cloud, new DroneKey("127.0.0.1", port, port % 10), name, new Geodetic(47.3977, 8.5456))
                .wellHeard(cloud);
        copter.waitsFor(gate::pass);
    }

    public String id() {
        return copter.id();
    }

    /** If its newest orders are to. */
    public void comesDown() {
        List<Command> performed = copter.performed();
        List<Command> fresh = performed.subList(seen, performed.size());
        seen = performed.size();
        if (fresh.stream().noneMatch(ObedientCopter::endsAFlight)) {
            return;
        }
        copter.isOnGround();
        Waiting.until("it is down", () -> cloud.drone(new DroneId(copter.id())).filter(ObedientCopter::isDown));
    }

    private static boolean endsAFlight(Command command) {
        return command instanceof Command.Land || command instanceof Command.ReturnToLaunch;
    }

    private static boolean isDown(DroneState state) {
        return state.phase() == FlightPhase.ON_GROUND && Boolean.FALSE.equals(state.armed());
    }
}
