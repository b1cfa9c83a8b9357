package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/** Where a drone must end: landed on the ground of that place, or staying there in the air. */
@Stored(names = "place landed")
public record Finish(Place place, boolean landed) {
    public static Finish landing(Place ground) {
        return new Finish(ground, true);
    }

    public static Finish hovering(Place place) {
        return new Finish(place, false);
    }
}
