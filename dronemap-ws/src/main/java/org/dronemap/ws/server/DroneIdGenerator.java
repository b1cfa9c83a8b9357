package org.dronemap.ws.server;

import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.dronemap.core.drone.DroneId;

/** Makes up ids for new drones: ten letters and digits. */
public final class DroneIdGenerator implements Supplier<DroneId> {
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";

    private final RandomGenerator random;

    public DroneIdGenerator(RandomGenerator random) {
        this.random = random;
    }

    @Override
    public DroneId get() {
        StringBuilder id = new StringBuilder("d");
        while (id.length() < 10) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return new DroneId(id.toString());
    }
}
