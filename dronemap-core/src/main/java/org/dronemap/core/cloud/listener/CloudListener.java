package org.dronemap.core.cloud.listener;

import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;

/** Is told by the cloud manager of changes of drones, commands and control; must return at once. */
public interface CloudListener {
    default void droneChanged(DroneState state) {}

    default void droneRemoved(DroneId id) {}

    default void commandChanged(CommandRecord command) {}

    /** {@code now} is how the change left it. */
    default void controlChanged(DroneId drone, ControlState now, ControlChange change) {}
}
