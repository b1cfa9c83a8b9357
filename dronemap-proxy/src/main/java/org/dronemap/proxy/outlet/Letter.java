package org.dronemap.proxy.outlet;

import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;

/** What a client is to get; it is numbered, addressed and signed only when it goes. */
sealed interface Letter {
    /** What a vehicle said. */
    record OfVehicle(DroneId drone, Frame frame) implements Letter {}

    /** What the cloud says in the name of a component of a drone. */
    record ForVehicle(DroneId drone, int component, Message message) implements Letter {}

    /** What the cloud says for itself. */
    record OfCloud(Message message) implements Letter {}
}
