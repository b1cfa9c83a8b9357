package org.dronemap.ws.lab;

import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;

/** Something at the end of a wire that the server may know as a drone. */
public interface LabVehicle {
    /** As the server has it; empty: it knows no such drone. */
    Optional<DroneState> known();

    LabVehicleLink wire();

    /** What it does in truth, and what the server says of it. */
    String words();

    default DroneState state() {
        return known().orElseThrow(() -> new AssertionError("The server does not know this: " + words()));
    }

    default DroneId id() {
        return state().id();
    }
}
