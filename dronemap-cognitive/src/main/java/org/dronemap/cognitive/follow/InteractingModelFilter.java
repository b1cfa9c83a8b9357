package org.dronemap.cognitive.follow;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.geo.PlanePoint;

/**
 * Interacting multiple model filter of a followed target's motion, under one assumed noise of its phone. It goes on,
 * bends to its left or right, or changes its speed: an opinion is kept for each, and counts as much as it foretold the
 * fixes (interacting multiple models). Owned by its {@link TargetFilter}.
 */
final class InteractingModelFilter {
    private static final double LIKELY_SPEED = 3;
    private static final double LEAST_METERS = 0.4;
    /** No fix makes an opinion impossible. */
    private static final double LEAST_LIKELY = 1e-12;
    /** For how many fixes it counts how well they were foretold. */
    private static final double REMEMBERED_FIXES = 50;

    private static final List<MotionKalmanFilter.MotionModel> MANNERS = List.of(
            new MotionKalmanFilter.MotionModel(0.2, 0, 0),
            new MotionKalmanFilter.MotionModel(0.25, 1.6, 0.6),
            new MotionKalmanFilter.MotionModel(0.25, -1.6, 0.6),
            new MotionKalmanFilter.MotionModel(0.8, 0, 0));
    private static final double[] BEGINS = {0.55, 0.15, 0.15, 0.15};
    /** How often they change from each manner over to each other, a second. */
    private static final double[][] CHANGES = {
        {0, 0.05, 0.05, 0.03}, {0.3, 0, 0.06, 0.03}, {0.3, 0.06, 0, 0.03}, {0.3, 0.07, 0.07, 0}
    };

    private final NoiseModel phone;
    private final List<MotionKalmanFilter> beliefs =
            MANNERS.stream().map(MotionKalmanFilter::new).toList();
    private double[] weights = BEGINS;
    private double logLikelihood;

    /**
     * The noise of a phone's fixes, as shares of the accuracy that it reports.
     *
     * @param fresh what is new in the error of each fix, in metres an axis
     * @param wander by how much the rest changes in a second: most of an error stays from fix to fix, and is followed
     */
    record NoiseModel(double fresh, double wander) {}

    InteractingModelFilter(NoiseModel phone) {
        this.phone = phone;
    }

    void begin(PlanePoint spot, double accuracyMeters) {
        beliefs.forEach(belief ->
                belief.begin(spot.eastMeters(), spot.northMeters(), phone.fresh() * accuracyMeters, LIKELY_SPEED));
        weights = BEGINS;
    }

    void predict(double seconds, double accuracyMeters) {
        mix(seconds);
        beliefs.forEach(belief -> belief.predict(seconds, phone.wander() * accuracyMeters));
    }

    /** Each opinion begins from what all think, by how likely it is that the target changed over to it. */
    private void mix(double seconds) {
        int count = beliefs.size();
        double[] next = new double[count];
        double[][] means = new double[count][];
        double[][][] spreads = new double[count][][];
        for (int to = 0; to < count; to++) {
            double[] shares = new double[count];
            for (int from = 0; from < count; from++) {
                shares[from] = weights[from] * changes(from, to, seconds);
                next[to] += shares[from];
            }
            for (int from = 0; from < count; from++) {
                shares[from] /= next[to];
            }
            means[to] = mean(shares);
            spreads[to] = covariance(shares, means[to]);
        }
        for (int to = 0; to < count; to++) {
            beliefs.get(to).set(means[to], spreads[to]);
        }
        weights = next;
    }

    private static double changes(int from, int to, double seconds) {
        double often = 0;
        for (double one : CHANGES[from]) {
            often += one;
        }
        double stays = Math.exp(-often * seconds);
        return from == to ? stays : (1 - stays) * CHANGES[from][to] / often;
    }

    private double[] mean(double[] shares) {
        double[] mean = new double[MotionKalmanFilter.SIZE];
        for (int i = 0; i < MotionKalmanFilter.SIZE; i++) {
            for (int from = 0; from < shares.length; from++) {
                mean[i] += shares[from] * beliefs.get(from).mean()[i];
            }
        }
        return mean;
    }

    private double[][] covariance(double[] shares, double[] mean) {
        double[][] spread = new double[MotionKalmanFilter.SIZE][MotionKalmanFilter.SIZE];
        for (int from = 0; from < shares.length; from++) {
            MotionKalmanFilter belief = beliefs.get(from);
            for (int i = 0; i < MotionKalmanFilter.SIZE; i++) {
                for (int j = 0; j < MotionKalmanFilter.SIZE; j++) {
                    double apart = (belief.mean()[i] - mean[i]) * (belief.mean()[j] - mean[j]);
                    spread[i][j] += shares[from] * (belief.covariance()[i][j] + apart);
                }
            }
        }
        return spread;
    }

    /** How many sigmas a place is from where it is expected. */
    double normalizedInnovation(PlanePoint spot, double accuracyMeters) {
        double meters = Math.max(LEAST_METERS, phone.fresh() * accuracyMeters);
        return beliefs.stream()
                .mapToDouble(belief -> belief.normalizedInnovation(spot.eastMeters(), spot.northMeters(), meters))
                .min()
                .orElseThrow();
    }

    void update(PlanePoint spot, double accuracyMeters) {
        double meters = phone.fresh() * accuracyMeters;
        double likelihood = update(belief -> belief.update(spot.eastMeters(), spot.northMeters(), meters));
        logLikelihood = logLikelihood * (1 - 1 / REMEMBERED_FIXES) + Math.log(likelihood);
    }

    void updateVelocity(PhoneFix.Course course, double metersPerSecond) {
        double unused = update(belief -> belief.updateVelocity(course.eastward(), course.northward(), metersPerSecond));
    }

    /** Whoever found it likelier counts for more; returns how likely it was on the whole. */
    private double update(ToDoubleFunction<MotionKalmanFilter> likelihood) {
        double sum = 0;
        double[] learnt = new double[weights.length];
        for (int i = 0; i < weights.length; i++) {
            learnt[i] = weights[i] * (likelihood.applyAsDouble(beliefs.get(i)) + LEAST_LIKELY);
            sum += learnt[i];
        }
        for (int i = 0; i < weights.length; i++) {
            learnt[i] /= sum;
        }
        weights = learnt;
        return sum;
    }

    /** How well it foretold the last fixes: the logarithm of a likelihood. */
    double logLikelihood() {
        return logLikelihood;
    }

    /** So many seconds after the newest fix. */
    PlanarMotion after(double seconds) {
        PlanarMotion sum = PlanarMotion.NONE;
        for (int i = 0; i < weights.length; i++) {
            sum = sum.plus(beliefs.get(i).after(seconds), weights[i]);
        }
        return sum;
    }
}
