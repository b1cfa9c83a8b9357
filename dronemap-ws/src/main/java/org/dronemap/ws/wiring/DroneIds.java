package org.dronemap.ws.wiring;

import java.security.SecureRandom;
import java.util.function.Supplier;
import org.dronemap.core.drone.DroneId;

/** Makes up ids for new drones: ten letters and digits. */
final class DroneIds implements Supplier<DroneId> {
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";

    private final SecureRandom random = new SecureRandom();

    @Override
    public DroneId get() {
        StringBuilder id = new StringBuilder("d");
        while (id.length() < 10) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return new DroneId(id.toString());
    }
}
