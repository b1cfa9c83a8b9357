package org.dronemap.core.drone;

/**
 * Top-view map image of a robot's surroundings, placed in metres in the robot's own frame.
 *
 * @param leftMeters x of its left edge
 * @param bottomMeters y of its lower edge
 */
public record AreaMap(
        Picture picture, double leftMeters, double bottomMeters, double widthMeters, double heightMeters) {
    private static final double LARGEST_METERS = 100_000;

    public AreaMap {
        boolean placed = Math.abs(leftMeters) <= LARGEST_METERS && Math.abs(bottomMeters) <= LARGEST_METERS;
        boolean sized =
                widthMeters > 0 && widthMeters <= LARGEST_METERS && heightMeters > 0 && heightMeters <= LARGEST_METERS;
        if (!placed || !sized) {
            throw new IllegalArgumentException("a map has a place and a size: " + leftMeters + ", " + bottomMeters
                    + ", " + widthMeters + " x " + heightMeters);
        }
    }
}
