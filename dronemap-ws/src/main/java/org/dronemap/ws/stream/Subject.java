package org.dronemap.ws.stream;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.zone.Zone;
import org.dronemap.ws.service.PlanJob;

/** The thing that a message of the stream is about; ids are unique among things of one kind. */
record Subject(String kind, String id) {
    private static final String DRONE = "drone";

    static Subject drone(DroneId id) {
        return new Subject(DRONE, id.value());
    }

    static Subject zone(Zone zone) {
        return new Subject("zone", zone.id());
    }

    static Subject virtualDrone(VirtualDrone drone) {
        return new Subject("virtualDrone", drone.id().value());
    }

    static Subject plan(PlanJob job) {
        return new Subject("plan", job.id());
    }

    static Subject run(SavedOperation run) {
        return new Subject("run", run.id().value());
    }

    static Subject follow(SavedOperation follow) {
        return new Subject("follow", follow.id().value());
    }

    /** The part of a follow that changes all the time. */
    static Subject followNow(SavedOperation follow) {
        return new Subject("followNow", follow.id().value());
    }

    boolean isDrone() {
        return kind.equals(DRONE);
    }
}
