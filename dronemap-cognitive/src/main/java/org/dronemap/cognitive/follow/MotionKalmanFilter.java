package org.dronemap.cognitive.follow;

/**
 * Extended Kalman filter for one motion model of a followed target: position, velocity and lateral acceleration. Owned
 * by its {@link InteractingModelFilter}.
 */
final class MotionKalmanFilter {
    static final int SIZE = 5;
    private static final int LEAN = 4;
    private static final double NUDGE = 1e-4;
    /** Whoever is slower turns no quicker than at this speed, m/s. */
    private static final double SLOW = 1.5;

    private final MotionModel manner;
    private double[] mean = new double[SIZE];
    private double[][] covariance = new double[SIZE][SIZE];

    /**
     * A motion model: how fast speed changes, and the lateral acceleration in bends. Whoever walks, runs or rides leans
     * into bends about as much: how quickly they turn follows from that and from their speed.
     *
     * @param push what speeds change by in a second, m/s (one sigma)
     * @param lean the acceleration to its left, m/s²; 0: it goes straight on
     * @param leanSpread how much more or less that may be (one sigma)
     */
    record MotionModel(double push, double lean, double leanSpread) {}

    MotionKalmanFilter(MotionModel manner) {
        this.manner = manner;
    }

    /** It is there, within so many metres, and may move with so many m/s. */
    void begin(double east, double north, double meters, double speed) {
        mean = new double[] {east, north, 0, 0, 0};
        covariance = new double[SIZE][SIZE];
        for (int i = 0; i < LEAN; i++) {
            covariance[i][i] = i < 2 ? meters * meters : speed * speed;
        }
        resetTurn();
    }

    void set(double[] newMean, double[][] newSpread) {
        mean = newMean;
        covariance = newSpread;
    }

    double[] mean() {
        return mean;
    }

    double[][] covariance() {
        return covariance;
    }

    /** How it moves after so many seconds. */
    PlanarMotion after(double seconds) {
        return motion(mean).after(seconds);
    }

    private static PlanarMotion motion(double[] state) {
        double speed = Math.hypot(state[2], state[3]);
        return new PlanarMotion(state[0], state[1], state[2], state[3], state[LEAN] / Math.max(SLOW, speed));
    }

    private static double[] moved(double[] from, double seconds) {
        PlanarMotion after = motion(from).after(seconds);
        return new double[] {after.east(), after.north(), after.eastward(), after.northward(), from[LEAN]};
    }

    /** Lets time pass; {@code wander}: what the phone's error changes by meanwhile, in metres an axis for a second. */
    void predict(double seconds, double wander) {
        resetTurn();
        double[][] change = new double[SIZE][SIZE];
        for (int column = 0; column < SIZE; column++) {
            double[] more = mean.clone();
            double[] less = mean.clone();
            more[column] += NUDGE;
            less[column] -= NUDGE;
            double[] high = moved(more, seconds);
            double[] low = moved(less, seconds);
            for (int row = 0; row < SIZE; row++) {
                change[row][column] = (high[row] - low[row]) / (2 * NUDGE);
            }
        }
        mean = moved(mean, seconds);
        covariance = product(product(change, covariance), transposed(change));
        double pushed = manner.push() * manner.push();
        for (int axis = 0; axis < 2; axis++) {
            covariance[axis][axis] += (pushed * seconds * seconds / 3 + wander * wander) * seconds;
            covariance[axis][axis + 2] += pushed * seconds * seconds / 2;
            covariance[axis + 2][axis] += pushed * seconds * seconds / 2;
            covariance[axis + 2][axis + 2] += pushed * seconds;
        }
    }

    /** What was learnt of it before counts no longer: it may lean otherwise from one fix to the next. */
    private void resetTurn() {
        mean[LEAN] = manner.lean();
        for (int i = 0; i < SIZE; i++) {
            covariance[LEAN][i] = 0;
            covariance[i][LEAN] = 0;
        }
        covariance[LEAN][LEAN] = manner.leanSpread() * manner.leanSpread();
    }

    /** How many sigmas a place is from where it is expected. */
    double normalizedInnovation(double east, double north, double meters) {
        return Math.sqrt(squared(east - mean[0], north - mean[1], meters));
    }

    private double squared(double east, double north, double meters) {
        return squared(0, east, north, meters);
    }

    /** {@code first}: the first of the two that something is known of now. */
    private double squared(int first, double east, double north, double sigma) {
        double a = covariance[first][first] + sigma * sigma;
        double b = covariance[first][first + 1];
        double c = covariance[first + 1][first + 1] + sigma * sigma;
        return (c * east * east - 2 * b * east * north + a * north * north) / (a * c - b * b);
    }

    /** Takes a place into account; returns how likely it was. */
    double update(double east, double north, double meters) {
        return update(0, east, north, meters);
    }

    /** The same for a velocity in m/s. */
    double updateVelocity(double eastward, double northward, double metersPerSecond) {
        return update(2, eastward, northward, metersPerSecond);
    }

    private double update(int first, double one, double other, double sigma) {
        double a = covariance[first][first] + sigma * sigma;
        double b = covariance[first][first + 1];
        double c = covariance[first + 1][first + 1] + sigma * sigma;
        double size = a * c - b * b;
        double offOne = one - mean[first];
        double offOther = other - mean[first + 1];
        double likelihood = Math.exp(-squared(first, offOne, offOther, sigma) / 2) / (2 * Math.PI * Math.sqrt(size));
        double[][] before = covariance;
        double[][] after = new double[SIZE][SIZE];
        for (int i = 0; i < SIZE; i++) {
            double gainOne = (before[i][first] * c - before[i][first + 1] * b) / size;
            double gainOther = (before[i][first + 1] * a - before[i][first] * b) / size;
            mean[i] += gainOne * offOne + gainOther * offOther;
            for (int j = 0; j < SIZE; j++) {
                after[i][j] = before[i][j] - gainOne * before[first][j] - gainOther * before[first + 1][j];
            }
        }
        covariance = evened(after);
        return likelihood;
    }

    /** What rounding has made of it would grow. */
    private static double[][] evened(double[][] matrix) {
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < i; j++) {
                matrix[i][j] = (matrix[i][j] + matrix[j][i]) / 2;
                matrix[j][i] = matrix[i][j];
            }
        }
        return matrix;
    }

    private static double[][] product(double[][] one, double[][] other) {
        double[][] product = new double[SIZE][SIZE];
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) {
                for (int k = 0; k < SIZE; k++) {
                    product[i][j] += one[i][k] * other[k][j];
                }
            }
        }
        return product;
    }

    private static double[][] transposed(double[][] matrix) {
        double[][] transposed = new double[SIZE][SIZE];
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) {
                transposed[j][i] = matrix[i][j];
            }
        }
        return transposed;
    }
}
