package org.dronemap.core.zone;

import org.dronemap.core.drone.DroneId;

/** Drones that a zone binds: all, those that a certain user flies, or one drone. */
public sealed interface ZoneBinding {
    Everybody EVERYBODY = new Everybody();

    boolean binds(String user, DroneId drone);

    /** All drones, whoever flies them. */
    record Everybody() implements ZoneBinding {
        @Override
        public boolean binds(String user, DroneId drone) {
            return true;
        }
    }

    /** Whatever this user flies. */
    record OfUser(String name) implements ZoneBinding {
        @Override
        public boolean binds(String user, DroneId drone) {
            return name.equals(user);
        }
    }

    /** One drone, whoever flies it. */
    record OfDrone(DroneId id) implements ZoneBinding {
        @Override
        public boolean binds(String user, DroneId drone) {
            return id.equals(drone);
        }
    }
}
