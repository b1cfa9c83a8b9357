package org.dronemap.ws.testserver;

import java.util.List;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.geo.Geodetic;

/** A willing copter that stands where simulated ones do, acts while a gate is open, and is down and disarmed once it was told to land or to come home. */
public final class LatchedCopter {
    private final CloudManager cloud;
    private final ImmediateCopter copter;
    private int seen;

    public LatchedCopter(CloudManager cloud, int port, String name, ResponseLatch gate) {
        this.cloud = cloud;
        copter = new ImmediateCopter(
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
        if (fresh.stream().noneMatch(LatchedCopter::endsAFlight)) {
            return;
        }
        copter.isOnGround();
        ConditionWait.until(
                "it is down", () -> cloud.drone(new DroneId(copter.id())).filter(LatchedCopter::isDown));
    }

    private static boolean endsAFlight(Command command) {
        return command instanceof Command.Land || command instanceof Command.ReturnToLaunch;
    }

    private static boolean isDown(DroneState state) {
        return state.phase() == FlightPhase.ON_GROUND && Boolean.FALSE.equals(state.armed());
    }
}
