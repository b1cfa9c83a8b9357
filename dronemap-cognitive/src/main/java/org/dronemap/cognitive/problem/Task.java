package org.dronemap.cognitive.problem;

import java.util.Set;

/** What is done at a waypoint: how long a drone stays for it, and what it must be able to do. */
public record Task(double serviceSeconds, Set<Skill> needs) {
    public static final Task FLY_THROUGH = new Task(0, Set.of());

    private static final double LONGEST_SECONDS = 86_400;

    public Task {
        Require.within("serviceSeconds", serviceSeconds, 0, LONGEST_SECONDS);
        needs = Set.copyOf(needs);
    }
}
