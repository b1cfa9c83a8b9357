package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.jspecify.annotations.Nullable;

/**
 * Says from a phone's fixes where it is, how it moves and where it will be. It goes on, turns, or changes its speed: three
 * opinions are kept, and each counts as much as it foretold the fixes (interacting multiple models). Owned by one thread.
 */
public final class TargetFilter implements Followed {
    /** What becomes of a fix. */
    public enum Verdict {
        TAKEN,
        /** It is older than one that was taken. */
        LATE,
        /** The phone itself does not know where it is. */
        VAGUE,
        /** Nothing that is followed moves so; if more fixes say the same, they are believed. */
        OUTLIER
    }

    static final double VAGUE_METERS = 50;
    private static final double FAR_OFF_SIGMAS = 6;
    private static final int BELIEVED_AFTER = 3;
    private static final double LEAST_METERS = 0.4;
    /** Of a speed that a receiver measured, m/s. */
    private static final double SPEED_ACCURACY = 0.5;

    private static final double LIKELY_SPEED = 3;
    private static final Duration FORGOTTEN = Duration.ofSeconds(20);
    /** Nobody goes on as before for longer. */
    private static final double LONGEST_SECONDS = 4;

    private static final double NANOS = 1e9;

    private final Habits habits;
    private final List<Belief> beliefs;
    private double[] weights = {0.6, 0.2, 0.2};
    private final LocalPlane plane;
    private @Nullable Instant last;
    private int outliers;

    /**
     * What those who are followed do.
     *
     * @param fresh most of a phone's error stays the same from fix to fix: the share of its accuracy that is new in each
     * @param stays how likely it is that they go on in their manner for a second
     */
    record Habits(double fresh, double stays, Belief.Manner straight, Belief.Manner turning, Belief.Manner changing) {
        static final Habits USUAL = new Habits(
                0.14, 0.78, new Belief.Manner(0.6, 0), new Belief.Manner(1.1, 0.4), new Belief.Manner(1.5, 0));
    }

    /** {@code near}: some place within some kilometres of where it will be. */
    public TargetFilter(Geodetic near) {
        this(near, Habits.USUAL);
    }

    TargetFilter(Geodetic near, Habits habits) {
        plane = new LocalPlane(near);
        this.habits = habits;
        beliefs = List.of(new Belief(habits.straight()), new Belief(habits.turning()), new Belief(habits.changing()));
    }

    public Verdict take(PhoneFix fix) {
        if (fix.accuracyMeters() > VAGUE_METERS) {
            return Verdict.VAGUE;
        }
        Instant before = last;
        double meters = Math.max(LEAST_METERS, habits.fresh() * fix.accuracyMeters());
        if (before == null || Duration.between(before, fix.at()).compareTo(FORGOTTEN) > 0) {
            begin(fix, meters);
            return Verdict.TAKEN;
        }
        double seconds = seconds(before, fix.at());
        if (seconds <= 0) {
            return Verdict.LATE;
        }
        Spot spot = plane.spot(fix.point());
        mix(seconds);
        beliefs.forEach(belief -> belief.pass(seconds));
        last = fix.at();
        boolean expected = beliefs.stream()
                .anyMatch(belief -> belief.surprise(spot.eastMeters(), spot.northMeters(), meters) < FAR_OFF_SIGMAS);
        if (!expected && ++outliers < BELIEVED_AFTER) {
            return Verdict.OUTLIER;
        }
        if (!expected) {
            begin(fix, meters);
            return Verdict.TAKEN;
        }
        outliers = 0;
        learn(belief -> belief.learn(spot.eastMeters(), spot.northMeters(), meters));
        PhoneFix.Course course = fix.course();
        if (course != null) {
            learn(belief -> belief.learnSpeed(course.eastward(), course.northward(), SPEED_ACCURACY));
        }
        return Verdict.TAKEN;
    }

    private void begin(PhoneFix fix, double meters) {
        Spot spot = plane.spot(fix.point());
        beliefs.forEach(belief -> belief.begin(spot.eastMeters(), spot.northMeters(), meters, LIKELY_SPEED));
        weights = new double[] {0.6, 0.2, 0.2};
        last = fix.at();
        outliers = 0;
    }

    /** Each opinion begins from what all think, by how likely it is that the target changed over to it. */
    private void mix(double seconds) {
        int count = beliefs.size();
        double stays = Math.pow(habits.stays(), Math.min(3, seconds));
        double changes = (1 - stays) / (count - 1);
        double[] next = new double[count];
        double[][] means = new double[count][];
        double[][][] spreads = new double[count][][];
        for (int to = 0; to < count; to++) {
            double[] shares = new double[count];
            for (int from = 0; from < count; from++) {
                shares[from] = weights[from] * (from == to ? stays : changes);
                next[to] += shares[from];
            }
            for (int from = 0; from < count; from++) {
                shares[from] /= next[to];
            }
            means[to] = mean(shares);
            spreads[to] = spread(shares, means[to]);
        }
        for (int to = 0; to < count; to++) {
            beliefs.get(to).set(means[to], spreads[to]);
        }
        weights = next;
    }

    private double[] mean(double[] shares) {
        double[] mean = new double[Belief.SIZE];
        for (int i = 0; i < Belief.SIZE; i++) {
            for (int from = 0; from < shares.length; from++) {
                mean[i] += shares[from] * beliefs.get(from).mean()[i];
            }
        }
        return mean;
    }

    private double[][] spread(double[] shares, double[] mean) {
        double[][] spread = new double[Belief.SIZE][Belief.SIZE];
        for (int from = 0; from < shares.length; from++) {
            Belief belief = beliefs.get(from);
            for (int i = 0; i < Belief.SIZE; i++) {
                for (int j = 0; j < Belief.SIZE; j++) {
                    double apart = (belief.mean()[i] - mean[i]) * (belief.mean()[j] - mean[j]);
                    spread[i][j] += shares[from] * (belief.spread()[i][j] + apart);
                }
            }
        }
        return spread;
    }

    /** Whoever found it likelier counts for more. */
    private void learn(ToDoubleFunction<Belief> likelihood) {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            // None is ever ruled out.
            weights[i] = Math.max(1e-3, weights[i] * likelihood.applyAsDouble(beliefs.get(i)) + 1e-12);
            sum += weights[i];
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] /= sum;
        }
    }

    @Override
    public LocalPlane plane() {
        return plane;
    }

    /** When the newest fix is from; null: there is none. */
    public @Nullable Instant last() {
        return last;
    }

    @Override
    public @Nullable Motion at(Instant time) {
        Instant from = last;
        if (from == null) {
            return null;
        }
        double seconds = Math.max(0, Math.min(LONGEST_SECONDS, seconds(from, time)));
        Motion sum = new Motion(0, 0, 0, 0, 0);
        for (int i = 0; i < weights.length; i++) {
            Motion one = beliefs.get(i).motion().after(seconds);
            double share = weights[i];
            sum = new Motion(
                    sum.east() + share * one.east(),
                    sum.north() + share * one.north(),
                    sum.eastward() + share * one.eastward(),
                    sum.northward() + share * one.northward(),
                    sum.turn() + share * one.turn());
        }
        return sum;
    }

    /** Where it was by its newest fixes, without a look ahead; null: nothing is known of it. */
    public @Nullable Geodetic where() {
        Motion now = last == null ? null : at(last);
        return now == null ? null : plane.place(now.spot());
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() / NANOS;
    }
}
