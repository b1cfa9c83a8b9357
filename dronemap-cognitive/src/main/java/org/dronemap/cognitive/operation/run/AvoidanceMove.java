package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.dronemap.cognitive.operation.run.TrajectoryForecast.Trajectory;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.plan.BarrierCheck;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * The smallest evasive move of a mission run's drone that would be too near to others even if it held still.
 *
 * @param to where it goes
 * @param seconds how long that takes at most
 * @param clearance how far it stays from the others, as a share of the least distance
 * @param words what it does, as the end of a sentence
 */
record AvoidanceMove(Place to, double meters, double seconds, double clearance, String words) {
    private static final double[] CLIMBS = {3, 6, 9, -3, -6, -9, 12};
    private static final double[] ASIDE = {8, 16, 24};
    private static final int DIRECTIONS = 8;
    /** It never goes nearer to the ground of its home than this. */
    private static final double LOWEST_METERS = 8;
    /** What comes out less than this much better is not worth going for. */
    private static final double WORTH = 0.15;

    private static final double METERS_PER_DEGREE = 111_320;
    /** Until it is told, and until it stands there. */
    private static final double BESIDE_SECONDS = 1.5;

    boolean isClear() {
        return clearance >= 1;
    }

    /**
     * The smallest that leaves it clear of all; else the one that leaves it farthest away, where that is better than standing.
     *
     * @param clearance how far from the others it is on such a way
     */
    static Optional<AvoidanceMove> of(
            RunDrone drone,
            Place from,
            List<Barrier> barriers,
            TrajectoryForecast tracks,
            ToDoubleFunction<Trajectory> clearance) {
        double standing = clearance.applyAsDouble(tracks.dodging(drone, from, from));
        BarrierCheck fences = new BarrierCheck(barriers, drone.craft());
        @Nullable AvoidanceMove best = null;
        for (AvoidanceMove step : steps(drone, from)) {
            if (fences.fault(new TimedPlace(from, 0), new TimedPlace(step.to(), step.seconds()), false)
                    .isPresent()) {
                continue;
            }
            AvoidanceMove seen = step.with(clearance.applyAsDouble(tracks.dodging(drone, from, step.to())));
            if (best == null || seen.isBetterThan(best)) {
                best = seen;
            }
        }
        return Optional.ofNullable(best).filter(found -> found.clearance() > standing + WORTH);
    }

    /** Of two that are clear the smaller, else the clearer. */
    boolean isBetterThan(AvoidanceMove other) {
        if (isClear() && other.isClear()) {
            return meters < other.meters();
        }
        return clearance > other.clearance();
    }

    private static List<AvoidanceMove> steps(RunDrone drone, Place from) {
        Speeds speeds = drone.craft().performance().speeds();
        List<AvoidanceMove> steps = new ArrayList<>();
        double lowest = Math.min(from.altitudeAmslMeters(), drone.craft().homeAmslMeters() + LOWEST_METERS);
        for (double climb : CLIMBS) {
            double height = from.altitudeAmslMeters() + climb;
            if (height >= lowest) {
                double pace = climb > 0 ? speeds.climb() : speeds.descent();
                String words =
                        String.format(Locale.ROOT, "%s %.0f m", climb > 0 ? "climbs" : "descends", Math.abs(climb));
                steps.add(step(from.at(height), Math.abs(climb), pace, words));
            }
        }
        for (double meters : ASIDE) {
            for (int d = 0; d < DIRECTIONS; d++) {
                Place there = aside(from, Math.toRadians(360.0 * d / DIRECTIONS), meters);
                steps.add(
                        step(there, meters, speeds.cruise(), String.format(Locale.ROOT, "goes %.0f m aside", meters)));
            }
        }
        return steps;
    }

    /** Some metres need no ellipsoid. */
    private static Place aside(Place from, double bearing, double meters) {
        double latitude = from.point().latitudeDegrees();
        double north = meters * Math.cos(bearing) / METERS_PER_DEGREE;
        double east = meters * Math.sin(bearing) / (METERS_PER_DEGREE * Math.cos(Math.toRadians(latitude)));
        return new Place(
                new Geodetic(latitude + north, from.point().longitudeDegrees() + east), from.altitudeAmslMeters());
    }

    private static AvoidanceMove step(Place to, double meters, double pace, String words) {
        return new AvoidanceMove(to, meters, meters / pace + BESIDE_SECONDS, 0, words);
    }

    private AvoidanceMove with(double seen) {
        return new AvoidanceMove(to, meters, seconds, seen, words);
    }
}
