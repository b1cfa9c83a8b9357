package org.dronemap.cognitive.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.jspecify.annotations.Nullable;

/**
 * Estimates from a followed phone's position fixes where it is, how it moves and where it will be. What a phone says of
 * its accuracy tells little of how its error changes: each {@link InteractingModelFilter} of that counts as much as it
 * foretold the fixes. Owned by one thread.
 */
public final class TargetFilter implements TrackedTarget {
    /** The result of a fix for the filter. */
    public enum FixResult {
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
    /** No phone is taken to be better than one that tells so many metres. */
    private static final double LEAST_METERS = 2;
    /** Of a speed that a receiver measured, m/s. */
    private static final double SPEED_ACCURACY = 0.3;

    private static final Duration FORGOTTEN = Duration.ofSeconds(20);
    /** Nobody goes on as before for longer. */
    private static final double LONGEST_SECONDS = 4;

    private static final double NANOS = 1e9;

    private static final List<InteractingModelFilter.NoiseModel> PHONES = List.of(
            new InteractingModelFilter.NoiseModel(0.02, 0.01),
            new InteractingModelFilter.NoiseModel(0.05, 0.04),
            new InteractingModelFilter.NoiseModel(0.12, 0.1),
            new InteractingModelFilter.NoiseModel(0.3, 0.25));

    private final List<InteractingModelFilter> hypotheses =
            PHONES.stream().map(InteractingModelFilter::new).toList();
    private final LocalPlane plane;
    private @Nullable Instant last;
    private int outliers;

    /** {@code near}: some place within some kilometres of where it will be. */
    public TargetFilter(Geodetic near) {
        plane = new LocalPlane(near);
    }

    public FixResult update(PhoneFix fix) {
        if (fix.accuracyMeters() > VAGUE_METERS) {
            return FixResult.VAGUE;
        }
        Instant before = last;
        double meters = Math.max(LEAST_METERS, fix.accuracyMeters());
        if (before == null || Duration.between(before, fix.at()).compareTo(FORGOTTEN) > 0) {
            begin(fix, meters);
            return FixResult.TAKEN;
        }
        double seconds = seconds(before, fix.at());
        if (seconds <= 0) {
            return FixResult.LATE;
        }
        PlanePoint spot = plane.spot(fix.point());
        hypotheses.forEach(hypothesis -> hypothesis.predict(seconds, meters));
        last = fix.at();
        boolean expected = hypotheses.stream()
                .anyMatch(hypothesis -> hypothesis.normalizedInnovation(spot, meters) < FAR_OFF_SIGMAS);
        if (!expected && ++outliers < BELIEVED_AFTER) {
            return FixResult.OUTLIER;
        }
        if (!expected) {
            begin(fix, meters);
            return FixResult.TAKEN;
        }
        outliers = 0;
        hypotheses.forEach(hypothesis -> hypothesis.update(spot, meters));
        PhoneFix.Course course = fix.course();
        if (course != null) {
            hypotheses.forEach(hypothesis -> hypothesis.updateVelocity(course, SPEED_ACCURACY));
        }
        return FixResult.TAKEN;
    }

    private void begin(PhoneFix fix, double meters) {
        hypotheses.forEach(hypothesis -> hypothesis.begin(plane.spot(fix.point()), meters));
        last = fix.at();
        outliers = 0;
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
    public @Nullable PlanarMotion at(Instant time) {
        Instant from = last;
        if (from == null) {
            return null;
        }
        double seconds = Math.max(0, Math.min(LONGEST_SECONDS, seconds(from, time)));
        double best = hypotheses.stream()
                .mapToDouble(InteractingModelFilter::logLikelihood)
                .max()
                .orElseThrow();
        double all = 0;
        PlanarMotion sum = PlanarMotion.NONE;
        for (InteractingModelFilter hypothesis : hypotheses) {
            double likelihood = Math.exp(hypothesis.logLikelihood() - best);
            sum = sum.plus(hypothesis.after(seconds), likelihood);
            all += likelihood;
        }
        return PlanarMotion.NONE.plus(sum, 1 / all);
    }

    /** Where it was by its newest fixes, without a look ahead; null: nothing is known of it. */
    public @Nullable Geodetic position() {
        PlanarMotion now = last == null ? null : at(last);
        return now == null ? null : plane.place(now.spot());
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toNanos() / NANOS;
    }
}
