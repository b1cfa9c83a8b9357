package org.dronemap.core.cloud;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.core.drone.DroneId;

/** Whoever is there by any face. Any thread. */
final class Onlookers implements Presence {
    private final List<Presence> faces = new CopyOnWriteArrayList<>();

    void add(Presence face) {
        faces.add(face);
    }

    @Override
    public boolean isThere(String user, DroneId drone) {
        return faces.stream().anyMatch(face -> face.isThere(user, drone));
    }
}
