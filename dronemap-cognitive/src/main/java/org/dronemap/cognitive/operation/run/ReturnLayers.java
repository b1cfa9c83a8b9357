package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.dronemap.cognitive.plan.BarrierCheck;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.VehicleKind;
import org.jspecify.annotations.Nullable;

/**
 * Altitude layers above all planned flight, for drones of a mission run that have no way home by its plan: those that do not
 * fly at first, and those that join.
 */
final class ReturnLayers {
    /** What vehicles climb to where nobody says otherwise, in m over their homes. */
    private static final double LEAST_METERS = 15;
    /** Beside the least distance: heights are held to some decimetres. */
    private static final double ROOM_METERS = 1;
    /** Over its home; what rules let drones fly without special permission. */
    private static final double MOST_METERS = 120;

    private final double lowest;
    private final double between;
    private final List<Barrier> barriers;
    private final List<Place> places;

    private ReturnLayers(double flown, double vertical, List<Barrier> barriers, List<Place> places) {
        between = vertical + ROOM_METERS;
        lowest = flown + between;
        this.barriers = barriers;
        this.places = places;
    }

    static ReturnLayers of(PlanningProblem problem, Plan plan) {
        DoubleStream homes = problem.crafts().stream()
                .mapToDouble(craft -> craft.finish().place().altitudeAmslMeters() + LEAST_METERS);
        DoubleStream ways = plan.tours().stream()
                .flatMap(tour -> tour.ways().stream())
                .flatMap(way -> way.fixes().stream())
                .mapToDouble(fix -> fix.place().altitudeAmslMeters());
        Stream<Place> waypoints = problem.waypoints().stream().map(Waypoint::place);
        return new ReturnLayers(
                DoubleStream.concat(homes, ways).max().orElse(0),
                problem.rules().separation().verticalMeters(),
                problem.barriers(),
                waypoints.toList());
    }

    /** For one that joins: over all others. */
    static ReturnLayers above(RunTransition draft) {
        DoubleStream layers = draft.drones().stream()
                .mapToDouble(drone -> drone.craft().finish().place().altitudeAmslMeters()
                        + Objects.requireNonNullElse(drone.profile().returnMeters(), LEAST_METERS));
        DoubleStream places = draft.targets().stream()
                .mapToDouble(target -> target.waypoint().place().altitudeAmslMeters());
        return new ReturnLayers(
                DoubleStream.concat(layers, places).max().orElse(0),
                draft.setting().rules().separation().verticalMeters(),
                draft.setting().barriers(),
                draft.targets().stream()
                        .map(target -> target.waypoint().place())
                        .toList());
    }

    /**
     * In m over its home; null: there is no room below what it must stay under, or it comes home another way.
     *
     * @param number of the drone: those that are more than there are layers share them
     */
    @Nullable
    Double of(Craft craft, VehicleKind kind, int number) {
        if (!kind.isRotorcraft()) {
            return null;
        }
        List<Double> layers = layers(craft);
        return layers.isEmpty() ? null : layers.get(number % layers.size());
    }

    private List<Double> layers(Craft craft) {
        Place home = craft.finish().place();
        BarrierCheck fences = new BarrierCheck(barriers, craft);
        List<Double> layers = new ArrayList<>();
        for (double amsl = lowest; amsl - home.altitudeAmslMeters() <= MOST_METERS; amsl += between) {
            double height = amsl;
            boolean free = Stream.concat(Stream.of(home), places.stream())
                    .map(place -> new TimedPlace(place.at(height), 0))
                    .allMatch(fix -> fences.fault(fix, fix, false).isEmpty());
            if (free) {
                // Some autopilots know whole metres only.
                layers.add(Math.ceil(height - home.altitudeAmslMeters()));
            }
        }
        return layers;
    }
}
