package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.separation.Separation;

/**
 * Finds the conflicts between a plan's drones in the air, in time steps so short that none is missed. Drones on the
 * ground count for nothing.
 */
public final class SeparationCheck {
    /** Nearer to the limit than this is at it. */
    private static final double TOUCH_METERS = 0.02;

    private final Separation separation;

    SeparationCheck(Separation separation) {
        this.separation = separation;
    }

    /** The first of each two drones. */
    public static List<SeparationConflict> conflicts(PlanningProblem problem, Plan plan) {
        LocalPlane plane =
                new LocalPlane(problem.crafts().get(0).start().place().point());
        Map<DroneId, Craft> crafts =
                problem.crafts().stream().collect(Collectors.toMap(Craft::id, Function.identity()));
        List<TourTrajectory> traces = new ArrayList<>();
        for (Tour tour : plan.tours()) {
            Craft craft = crafts.get(tour.drone());
            if (craft != null) {
                traces.add(TourTrajectory.of(craft, tour, plane));
            }
        }
        SeparationCheck check = new SeparationCheck(problem.rules().separation());
        List<SeparationConflict> conflicts = new ArrayList<>();
        for (int i = 0; i < traces.size(); i++) {
            for (int j = i + 1; j < traces.size(); j++) {
                check.first(traces.get(i), traces.get(j)).ifPresent(conflicts::add);
            }
        }
        return conflicts;
    }

    Optional<SeparationConflict> first(TourTrajectory one, TourTrajectory other) {
        double from = Math.max(one.fromSeconds(), other.fromSeconds());
        double till = Math.min(one.tillSeconds(), other.tillSeconds());
        int i = one.pieceAt(from);
        int j = other.pieceAt(from);
        while (from < till && i < one.pieces().size() && j < other.pieces().size()) {
            TourTrajectory.Piece mine = one.pieces().get(i);
            TourTrajectory.Piece yours = other.pieces().get(j);
            double both = Math.min(mine.tillSeconds(), yours.tillSeconds());
            if (both > from && !mine.isBeyond(yours, separation.horizontalMeters()) && !isStacked(mine, yours)) {
                Optional<SeparationConflict> conflict = meet(new PiecePair(one, mine, other, yours), from, both);
                if (conflict.isPresent()) {
                    return conflict;
                }
            }
            from = Math.max(from, both);
            i = mine.tillSeconds() <= both ? i + 1 : i;
            j = yours.tillSeconds() <= both ? j + 1 : j;
        }
        return Optional.empty();
    }

    private record PiecePair(
            TourTrajectory one, TourTrajectory.Piece mine, TourTrajectory other, TourTrajectory.Piece yours) {
        double meters(double seconds) {
            double here = one.along(mine, seconds);
            double there = other.along(yours, seconds);
            double east = mine.middle().eastMeters()
                    - yours.middle().eastMeters()
                    + here * mine.east()
                    - there * yours.east();
            double north = mine.middle().northMeters()
                    - yours.middle().northMeters()
                    + here * mine.north()
                    - there * yours.north();
            return Math.sqrt(east * east + north * north);
        }
    }

    private boolean isStacked(TourTrajectory.Piece mine, TourTrajectory.Piece yours) {
        return mine.low() - yours.high() >= separation.verticalMeters()
                || yours.low() - mine.high() >= separation.verticalMeters();
    }

    private Optional<SeparationConflict> meet(PiecePair pair, double from, double till) {
        double fastest = pair.mine().peak() + pair.yours().peak();
        double seconds = from;
        while (true) {
            double meters = pair.meters(seconds);
            if (meters < separation.horizontalMeters()) {
                return Optional.of(new SeparationConflict(
                        pair.one().craft().id(), pair.other().craft().id(), seconds, meters));
            }
            if (fastest == 0 || seconds >= till) {
                return Optional.empty();
            }
            double stride = Math.max(TOUCH_METERS, meters - separation.horizontalMeters()) / fastest;
            if (seconds + stride >= till && stride * fastest > TOUCH_METERS) {
                return Optional.empty();
            }
            seconds = Math.min(till, seconds + stride);
        }
    }
}
