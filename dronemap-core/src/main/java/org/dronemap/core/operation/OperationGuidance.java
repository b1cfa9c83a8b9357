package org.dronemap.core.operation;

import java.util.Map;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;

/**
 * Computes setpoints for an operation's drones between its decisions, such as while following a phone. It is forgotten
 * with the process: nothing is steered then until it knows enough again. Owned by the conductor's thread.
 *
 * @param <S> what the operation remembers
 */
public interface OperationGuidance<S> {
    /** False: it is of no use, and no sign that what is guided may go on. */
    boolean reported(TargetReport sighting);

    /** What drones are told now, each time that the operation looks; who is not among them is let go of. */
    Map<DroneId, Setpoint> steer(S state, OperationObservation scene);
}
