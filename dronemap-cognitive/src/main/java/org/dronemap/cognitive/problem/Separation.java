package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/** The least separation of two drones in a plan: horizontal or vertical, in metres. */
@Stored(names = "horizontalMeters verticalMeters")
public record Separation(double horizontalMeters, double verticalMeters) {
    public static final Separation USUAL = new Separation(10, 5);

    public Separation {
        Require.within("horizontalMeters", horizontalMeters, 0, 10_000);
        Require.within("verticalMeters", verticalMeters, 0, 1_000);
    }
}
