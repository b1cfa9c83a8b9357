package org.dronemap.cognitive.cost;

/** Computes squared distances between straight segments on the planner's plane. */
final class SegmentDistances {
    private SegmentDistances() {}

    /** The square of the least distance between a piece and the origin. */
    static double squaredToOrigin(double x1, double y1, double x2, double y2) {
        double east = x2 - x1;
        double north = y2 - y1;
        double squared = east * east + north * north;
        double share = squared == 0 ? 0 : Math.max(0, Math.min(1, -(x1 * east + y1 * north) / squared));
        double nearX = x1 + share * east;
        double nearY = y1 + share * north;
        return nearX * nearX + nearY * nearY;
    }

    /** The square of the least distance between two pieces; 0 when they cross. */
    static double squared(double[] one, double x1, double y1, double x2, double y2) {
        double east = one[2] - one[0];
        double north = one[3] - one[1];
        double sideFrom = east * (y1 - one[1]) - north * (x1 - one[0]);
        double sideTo = east * (y2 - one[1]) - north * (x2 - one[0]);
        if (sideFrom * sideTo < 0) {
            double otherEast = x2 - x1;
            double otherNorth = y2 - y1;
            double sideOne = otherEast * (one[1] - y1) - otherNorth * (one[0] - x1);
            double sideTwo = otherEast * (one[3] - y1) - otherNorth * (one[2] - x1);
            if (sideOne * sideTwo < 0) {
                return 0;
            }
        }
        return Math.min(
                Math.min(
                        squaredToOrigin(one[0] - x1, one[1] - y1, one[2] - x1, one[3] - y1),
                        squaredToOrigin(one[0] - x2, one[1] - y2, one[2] - x2, one[3] - y2)),
                Math.min(
                        squaredToOrigin(x1 - one[0], y1 - one[1], x2 - one[0], y2 - one[1]),
                        squaredToOrigin(x1 - one[2], y1 - one[3], x2 - one[2], y2 - one[3])));
    }
}
