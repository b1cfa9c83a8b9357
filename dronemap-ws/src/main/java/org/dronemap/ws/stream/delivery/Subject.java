package org.dronemap.ws.stream.delivery;

import org.dronemap.core.drone.DroneId;

/** Subject of a stream message: a kind and an id that is unique within it. */
record Subject(String kind, String id) {
    static final String DRONE = "drone";

    static Subject drone(DroneId id) {
        return new Subject(DRONE, id.value());
    }

    boolean isDrone() {
        return kind.equals(DRONE);
    }
}
