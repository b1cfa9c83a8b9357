package org.dronemap.ws.stream.delivery;

import org.dronemap.core.drone.DroneId;

/** Subject of a stream message: a kind and an id that is unique within it. */
record MessageSubject(String kind, String id) {
    static final String DRONE = "drone";

    static MessageSubject drone(DroneId id) {
        return new MessageSubject(DRONE, id.value());
    }

    boolean isDrone() {
        return kind.equals(DRONE);
    }
}
