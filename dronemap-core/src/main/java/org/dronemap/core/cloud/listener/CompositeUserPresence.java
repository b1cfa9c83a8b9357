package org.dronemap.core.cloud.listener;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.core.drone.DroneId;

/** A UserPresence that asks several others: a user is present if any of them says so. Any thread. */
public final class CompositeUserPresence implements UserPresence {
    private final List<UserPresence> faces = new CopyOnWriteArrayList<>();

    public void add(UserPresence face) {
        faces.add(face);
    }

    @Override
    public boolean isThere(String user, DroneId drone) {
        return faces.stream().anyMatch(face -> face.isThere(user, drone));
    }
}
