package org.dronemap.ws.stream.delivery;

import org.dronemap.core.drone.DroneId;

/** The thing that a message of the stream is about; ids are unique among things of one kind. */
record Subject(String kind, String id) {
    static final String DRONE = "drone";

    static Subject drone(DroneId id) {
        return new Subject(DRONE, id.value());
    }

    boolean isDrone() {
        return kind.equals(DRONE);
    }
}
