package org.dronemap.cognitive.problem;

import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.ShapeValidator;
import org.dronemap.core.zone.Zone;

/**
 * An area that planned tours stay in or out of, within its band of altitudes, such as a no-fly zone.
 *
 * @param words what people call it: "the no-fly zone “Airport”"
 * @param drones whom it binds; nobody named: everybody
 */
@Stored(names = "words shape band drones")
public record Barrier(String words, FenceArea shape, AltitudeBand band, Set<DroneId> drones) {
    /** A circle is gone round in so many straight pieces. */
    public static final int CIRCLE_TURNS = 16;

    public Barrier {
        drones = Set.copyOf(drones);
        ShapeValidator.of(shape).ifPresent(fault -> {
            throw new IllegalArgumentException(words + ": " + fault);
        });
    }

    public static Barrier of(Zone zone) {
        return new Barrier(zone.words(), zone.shape(), zone.band(), Set.of());
    }

    /** As people gave it, without what it is: "Airport". */
    public String name() {
        String around = Zone.words(shape, "");
        String before = around.substring(0, around.length() - 1);
        boolean isNamed = words.startsWith(before) && words.length() >= around.length();
        return isNamed ? words.substring(before.length(), words.length() - 1) : words;
    }

    public boolean isKeepIn() {
        return shape.inside();
    }

    /** At how many spots ways round it may turn. */
    public int turns() {
        return shape instanceof FenceArea.Polygon polygon ? polygon.corners().size() : CIRCLE_TURNS;
    }

    public boolean binds(DroneId drone) {
        return drones.isEmpty() || drones.contains(drone);
    }
}
