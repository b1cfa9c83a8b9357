package org.dronemap.bench.planning;

/** The distance metric of a problem. */
public enum Metric {
    /** Straight, unrounded. */
    EUCLIDEAN {
        @Override
        double between(double dx, double dy) {
            return Math.sqrt(dx * dx + dy * dy);
        }
    },
    /** Pseudo-Euclidean of TSPLIB's att instances: a tenth of the square, then rounded up. */
    ATT {
        @Override
        double between(double dx, double dy) {
            return Math.ceil(Math.sqrt((dx * dx + dy * dy) / 10));
        }
    };

    abstract double between(double dx, double dy);

    public double between(TourPoint one, TourPoint other) {
        return between(one.x() - other.x(), one.y() - other.y());
    }
}
