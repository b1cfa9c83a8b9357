package org.dronemap.ws.stream.delivery;

import org.dronemap.core.drone.DroneId;

/** Subject of a stream message: a kind, such as drone, and an id that is unique within it. */
public record StreamMessageSubject(String kind, String id) {
    public static final String DRONE = "drone";

    public static StreamMessageSubject drone(DroneId id) {
        return new StreamMessageSubject(DRONE, id.value());
    }

    public boolean isDrone() {
        return kind.equals(DRONE);
    }
}
