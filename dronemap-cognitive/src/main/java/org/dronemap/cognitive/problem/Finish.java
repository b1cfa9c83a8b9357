package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/** The end of a drone's planned tour: landed at a place, or hovering there. */
@Stored(names = "place landed")
public record Finish(Place place, boolean landed) {
    public static Finish landing(Place ground) {
        return new Finish(ground, true);
    }

    public static Finish hovering(Place place) {
        return new Finish(place, false);
    }
}
