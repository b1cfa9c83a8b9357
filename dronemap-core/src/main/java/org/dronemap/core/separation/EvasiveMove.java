package org.dronemap.core.separation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.geo.PlanePoint;
import org.jspecify.annotations.Nullable;

/**
 * The smallest step aside of a drone that would be too near to others even if it held still.
 *
 * @param to where it goes
 * @param meters how far
 * @param seconds how long that takes at most
 * @param clearance how far it stays from the others, as a share of the least distance
 * @param words what it does, as the end of a sentence
 */
record EvasiveMove(TrackSample to, double meters, double seconds, double clearance, String words) {
    private static final double[] CLIMBS = {3, 6, 9, -3, -6, -9, 12};
    private static final double[] ASIDE = {8, 16, 24};
    private static final int DIRECTIONS = 8;
    /** It never goes nearer to the ground of its home than this. */
    private static final double LOWEST_METERS = 8;
    /** What comes out less than this much better is not worth going for. */
    private static final double WORTH = 0.15;
    /** Until it is told, and until it stands there. */
    private static final double BESIDE_SECONDS = 1.5;

    boolean isClear() {
        return clearance >= 1;
    }

    /**
     * The smallest that leaves it clear of all; else the one that leaves it farthest away, where that is better than standing.
     *
     * @param may whether it may go there
     * @param clearance how far from the others it is on such a way
     */
    static Optional<EvasiveMove> of(
            TrackedDrone drone,
            TrackSample from,
            TrackForecast forecast,
            Predicate<TrackSample> may,
            ToDoubleFunction<Track> clearance) {
        double standing = clearance.applyAsDouble(forecast.aside(drone, from, from));
        @Nullable EvasiveMove best = null;
        for (EvasiveMove step : steps(drone, from)) {
            EvasiveMove seen = step.with(clearance.applyAsDouble(forecast.aside(drone, from, step.to())));
            boolean worthIt = seen.clearance() > standing + WORTH && (best == null || seen.isBetterThan(best));
            if (worthIt && may.test(step.to())) {
                best = seen;
            }
        }
        return Optional.ofNullable(best);
    }

    /** Of two that are clear the smaller, else the clearer. */
    boolean isBetterThan(EvasiveMove other) {
        if (isClear() && other.isClear()) {
            return meters < other.meters();
        }
        return clearance > other.clearance();
    }

    private static List<EvasiveMove> steps(TrackedDrone drone, TrackSample from) {
        FlightPace pace = TrackForecast.pace(drone);
        List<EvasiveMove> steps = new ArrayList<>();
        double lowest = Math.min(from.low(), drone.homeAmslMeters().orElse(from.low()) + LOWEST_METERS);
        for (double climb : CLIMBS) {
            double height = from.low() + climb;
            if (height >= lowest) {
                double speed = climb > 0 ? pace.climb() : pace.descent();
                String words =
                        String.format(Locale.ROOT, "%s %.0f m", climb > 0 ? "climbs" : "descends", Math.abs(climb));
                steps.add(step(new TrackSample(from.spot(), height), Math.abs(climb), speed, words));
            }
        }
        for (double meters : ASIDE) {
            for (int d = 0; d < DIRECTIONS; d++) {
                double bearing = Math.toRadians(360.0 * d / DIRECTIONS);
                PlanePoint spot = new PlanePoint(
                        from.spot().eastMeters() + meters * Math.sin(bearing),
                        from.spot().northMeters() + meters * Math.cos(bearing));
                steps.add(step(
                        new TrackSample(spot, from.low()),
                        meters,
                        pace.cruise(),
                        String.format(Locale.ROOT, "goes %.0f m aside", meters)));
            }
        }
        return steps;
    }

    private static EvasiveMove step(TrackSample to, double meters, double speed, String words) {
        return new EvasiveMove(to, meters, meters / speed + BESIDE_SECONDS, 0, words);
    }

    private EvasiveMove with(double seen) {
        return new EvasiveMove(to, meters, seconds, seen, words);
    }
}
