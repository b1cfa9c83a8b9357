package org.dronemap.ws.control;

import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.Rejection;

/**
 * Passes setpoints of users who steer a drone by hand to the cloud manager, after checking rights and budgets. Any
 * thread; nothing here waits.
 */
public final class SteeringService {
    private final CloudManager cloud;
    private final DroneService drones;
    private final Budgets budgets;

    public SteeringService(CloudManager cloud, DroneService drones, Budgets budgets) {
        this.cloud = cloud;
        this.drones = drones;
        this.budgets = budgets;
    }

    /** Steers for at most half a second from now on; throws a rejection when nothing was taken. */
    public void steer(Principal principal, String face, String drone, SteeringRequest request) {
        budgets.charge(WorkKind.REQUEST, principal.name());
        DroneId id = drones.state(principal, drone, Role.OPERATOR).id();
        Setpoint setpoint = request.setpoint();
        Optional<Refusal> why;
        try {
            why = cloud.setpoints().steer(new CommandGate.Source(principal, face, request.epoch()), id, setpoint);
        } catch (UnknownDroneException removedMeanwhile) {
            throw Rejection.unknown(NotFoundProblem.DRONE, drone);
        }
        if (why.isPresent()) {
            throw Rejection.refused(why.get(), id, null, cloud.controls().control(id));
        }
    }

    /** Says why not to who may not steer that drone. */
    public void require(Principal principal, String drone) {
        drones.state(principal, drone, Role.OPERATOR);
    }

    /** Hands off: what this one steers stands still at once. What was begun by rights that are gone may be ended, too. */
    public void letGo(Principal principal, String face, String drone) {
        try {
            cloud.setpoints().stopSteering(new CommandGate.Source(principal, face), new DroneId(drone));
        } catch (UnknownDroneException removedMeanwhile) {
            // There is nothing left that could move.
        }
    }
}
