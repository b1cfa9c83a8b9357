package org.dronemap.core.conduct;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.time.Time;

/**
 * Sends drones home that an operation or a virtual drone has left, again until they are on their way. Owned by one
 * thread.
 */
final class ReturnCommander {
    private static final long BETWEEN_CALLS_NANOS = 5_000_000_000L;

    private final DroneGateway crew;
    private final Time time;
    private final Map<DroneId, Long> calledNanos = new HashMap<>();

    ReturnCommander(DroneGateway crew, Time time) {
        this.crew = crew;
        this.time = time;
    }

    /** Whether no more is to be done for it: it is on its way, on the ground, or somebody else's; else it is called. */
    boolean commandReturn(LeaseHolder.Operation by, DroneState drone) {
        if (crew.whyNotHeld(by, drone.id()) != null) {
            calledNanos.remove(drone.id());
            return true;
        }
        if (drone.link().state() != LinkState.LIVE || !drone.capabilities().known()) {
            return false;
        }
        boolean onItsWay = drone.capabilities().isSafe(drone.mode());
        if (Boolean.FALSE.equals(drone.armed()) || onItsWay) {
            calledNanos.remove(drone.id());
            crew.release(by, drone.id());
            return true;
        }
        long now = time.nanos();
        Long called = calledNanos.get(drone.id());
        if (called == null || now - called > BETWEEN_CALLS_NANOS) {
            calledNanos.put(drone.id(), now);
            crew.command(by, drone.id(), new CommandId(time.newId()), homeward(by, drone));
        }
        return false;
    }

    /** The best that it can do now; what the gate refuses is told there. */
    private Command homeward(LeaseHolder.Operation by, DroneState drone) {
        // Where nothing tells, it may well be in the air; what drives may be anywhere.
        if (drone.isOnGround() && !drone.identification().kind().neverFlies()) {
            return new Command.Disarm(false);
        }
        return Stream.of(new Command.ReturnToLaunch(), new Command.Land(), new Command.Hold())
                .filter(command -> crew.refusal(by, drone, command).isEmpty())
                .findFirst()
                .orElseGet(Command.ReturnToLaunch::new);
    }
}
