package org.dronemap.core.cloud.listener;

import java.util.List;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;

/** A CloudListener that passes each change on to several listeners. */
public record CompositeCloudListener(List<CloudListener> listeners) implements CloudListener {
    @Override
    public void droneChanged(DroneState state) {
        listeners.forEach(listener -> listener.droneChanged(state));
    }

    @Override
    public void droneRemoved(DroneId id) {
        listeners.forEach(listener -> listener.droneRemoved(id));
    }

    @Override
    public void commandChanged(CommandRecord command) {
        listeners.forEach(listener -> listener.commandChanged(command));
    }

    @Override
    public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
        listeners.forEach(listener -> listener.controlChanged(drone, now, change));
    }
}
