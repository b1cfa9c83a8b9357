package org.dronemap.cognitive.follow;

/**
 * One opinion of where the target is and how it moves, with its uncertainty: an extended Kalman filter over east, north, their
 * speeds and the rate of turn. Owned by its {@link TargetFilter}.
 */
final class Belief {
    static final int SIZE = 5;
    private static final int TURN = 4;
    private static final double NUDGE = 1e-4;
    private static final double TURN_SECONDS = 4;

    private final Manner manner;
    private double[] mean = new double[SIZE];
    private double[][] spread = new double[SIZE][SIZE];

    /**
     * How it is taken to move.
     *
     * @param acceleration what speeds change by, m/s² (one sigma)
     * @param turning the rate of turn that is usual, rad/s (one sigma), for some seconds each time; 0: it goes straight on
     */
    record Manner(double acceleration, double turning) {
        boolean turns() {
            return turning > 0;
        }
    }

    Belief(Manner manner) {
        this.manner = manner;
    }

    /** It is there, within so many metres, and may move with so many m/s. */
    void begin(double east, double north, double meters, double speed) {
        mean = new double[] {east, north, 0, 0, 0};
        spread = new double[SIZE][SIZE];
        for (int i = 0; i < TURN; i++) {
            spread[i][i] = i < 2 ? meters * meters : speed * speed;
        }
        spread[TURN][TURN] = manner.turning() * manner.turning();
    }

    void set(double[] newMean, double[][] newSpread) {
        mean = newMean;
        spread = newSpread;
    }

    double[] mean() {
        return mean;
    }

    double[][] spread() {
        return spread;
    }

    Motion motion() {
        return motion(mean);
    }

    private static Motion motion(double[] state) {
        return new Motion(state[0], state[1], state[2], state[3], state[TURN]);
    }

    private double[] moved(double[] from, double seconds) {
        Motion after = motion(from).after(seconds);
        double turn = after.turn() * Math.exp(-seconds / TURN_SECONDS);
        return new double[] {after.east(), after.north(), after.eastward(), after.northward(), turn};
    }

    /** Lets time pass. */
    void pass(double seconds) {
        if (!manner.turns()) {
            stopTurning();
        }
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
        spread = product(product(change, spread), transposed(change));
        double pushed = manner.acceleration() * manner.acceleration();
        for (int axis = 0; axis < 2; axis++) {
            spread[axis][axis] += pushed * Math.pow(seconds, 4) / 4;
            spread[axis][axis + 2] += pushed * Math.pow(seconds, 3) / 2;
            spread[axis + 2][axis] += pushed * Math.pow(seconds, 3) / 2;
            spread[axis + 2][axis + 2] += pushed * seconds * seconds;
        }
        spread[TURN][TURN] += manner.turning() * manner.turning() * (1 - Math.exp(-2 * seconds / TURN_SECONDS));
    }

    private void stopTurning() {
        mean[TURN] = 0;
        for (int i = 0; i < SIZE; i++) {
            spread[TURN][i] = 0;
            spread[i][TURN] = 0;
        }
    }

    /** How many sigmas a place is from where it is expected. */
    double surprise(double east, double north, double meters) {
        return Math.sqrt(squared(east - mean[0], north - mean[1], meters));
    }

    private double squared(double east, double north, double meters) {
        return squared(0, east, north, meters);
    }

    /** {@code first}: the first of the two that something is known of now. */
    private double squared(int first, double east, double north, double sigma) {
        double a = spread[first][first] + sigma * sigma;
        double b = spread[first][first + 1];
        double c = spread[first + 1][first + 1] + sigma * sigma;
        return (c * east * east - 2 * b * east * north + a * north * north) / (a * c - b * b);
    }

    /** Takes a place into account; returns how likely it was. */
    double learn(double east, double north, double meters) {
        return learn(0, east, north, meters);
    }

    /** The same for a velocity in m/s. */
    double learnSpeed(double eastward, double northward, double metersPerSecond) {
        return learn(2, eastward, northward, metersPerSecond);
    }

    private double learn(int first, double one, double other, double sigma) {
        double a = spread[first][first] + sigma * sigma;
        double b = spread[first][first + 1];
        double c = spread[first + 1][first + 1] + sigma * sigma;
        double size = a * c - b * b;
        double offOne = one - mean[first];
        double offOther = other - mean[first + 1];
        double likelihood = Math.exp(-squared(first, offOne, offOther, sigma) / 2) / (2 * Math.PI * Math.sqrt(size));
        double[][] before = spread;
        double[][] after = new double[SIZE][SIZE];
        for (int i = 0; i < SIZE; i++) {
            double gainOne = (before[i][first] * c - before[i][first + 1] * b) / size;
            double gainOther = (before[i][first + 1] * a - before[i][first] * b) / size;
            mean[i] += gainOne * offOne + gainOther * offOther;
            for (int j = 0; j < SIZE; j++) {
                after[i][j] = before[i][j] - gainOne * before[first][j] - gainOther * before[first + 1][j];
            }
        }
        spread = evened(after);
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
