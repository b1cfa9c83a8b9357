package org.dronemap.core.cloud.listener;

import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;

/** Hears what changes, on a lane or on the journal's thread; must return at once. */
public interface CloudListener {
    default void droneChanged(DroneState state) {}

    default void droneRemoved(DroneId id) {}

    default void commandChanged(CommandRecord command) {}

    /** {@code now} is how the change left it. */
    default void controlChanged(DroneId drone, ControlState now, ControlChange change) {}
}
