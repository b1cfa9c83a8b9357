package org.dronemap.proxy.outlet.client;

import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;

/** A message queued for one ground station at the outlet; numbered, addressed and signed when it is sent. */
public sealed interface ClientMessage {
    /** A frame that a vehicle sent. */
    record OfVehicle(DroneId drone, Frame frame) implements ClientMessage {}

    /** A message that the cloud sends in the name of a component of a drone. */
    record ForVehicle(DroneId drone, int component, Message message) implements ClientMessage {}

    /** A message that the cloud sends in its own name. */
    record OfCloud(Message message) implements ClientMessage {}
}
