package org.dronemap.ws.plan;

import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.engine.SearchProgress;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Maps planning jobs to the {@link PlanView} that all faces send; drones keep the names they had at the request. */
public final class PlanViewMapper {
    private static final double JOULES_PER_WATT_HOUR = 3_600;
    private static final double MILLIS = 1_000;
    private static final PlanePoint HERE = new PlanePoint(0, 0);

    private PlanViewMapper() {}

    /** With all that is known of it. */
    public static PlanView whole(PlanJob job) {
        return view(job, true);
    }

    /** Without its ways, for lists. */
    static PlanView brief(PlanJob job) {
        return view(job, false);
    }

    private static PlanView view(PlanJob job, boolean whole) {
        PlanJobInput order = job.order();
        PlanJob.Status status = job.status();
        List<PlanView.ProgressView> steps =
                status.steps().stream().map(PlanViewMapper::progress).toList();
        PlanResult result = status.result();
        return new PlanView(
                job.id(),
                job.owner(),
                job.askedAt().truncatedTo(ChronoUnit.MILLIS),
                WireNames.camel(status.state()),
                status.why(),
                order.search().toMillis() / MILLIS,
                order.seed(),
                order.drones().stream()
                        .map(drone -> new PlanView.DroneName(drone.id().value(), drone.name()))
                        .toList(),
                order.upTo(),
                order.problem().waypoints().size(),
                steps.isEmpty() ? null : steps.get(steps.size() - 1),
                whole ? steps : null,
                whole ? orders(order.problem(), status.orders()) : null,
                whole && result != null ? result(order, result) : null,
                launch(order, status));
    }

    private static PlanView.ProgressView progress(PlanJob.Step step) {
        SearchProgress progress = step.progress();
        return new PlanView.ProgressView(
                step.seconds(),
                progress.longestSeconds(),
                progress.sum(),
                progress.unserved(),
                progress.gap(),
                progress.iterations());
    }

    private static @Nullable List<PlanView.OrderView> orders(
            PlanningProblem problem, @Nullable List<List<Integer>> orders) {
        if (orders == null) {
            return null;
        }
        List<PlanView.OrderView> views = new ArrayList<>();
        for (int drone = 0; drone < orders.size(); drone++) {
            views.add(new PlanView.OrderView(
                    problem.crafts().get(drone).id().value(),
                    orders.get(drone).stream()
                            .map(number -> problem.waypoints().get(number).id())
                            .toList()));
        }
        return views;
    }

    private static PlanView.ResultView result(PlanJobInput order, PlanResult planned) {
        Map<DroneId, Craft> crafts =
                order.problem().crafts().stream().collect(Collectors.toMap(Craft::id, Function.identity()));
        return new PlanView.ResultView(
                planned.plan().endsSeconds(),
                planned.plan().tours().stream()
                        .flatMap(tour ->
                                Stream.ofNullable(crafts.get(tour.drone())).map(craft -> tour(order, craft, tour)))
                        .toList(),
                unserved(order.problem(), planned.plan()),
                order.faults(planned),
                order.problem().crafts().stream()
                        .anyMatch(craft -> craft.performance().assumed()));
    }

    static List<PlanView.UnservedView> unserved(PlanningProblem problem, Plan plan) {
        if (plan.unserved().isEmpty()) {
            return List.of();
        }
        Map<String, Place> places =
                problem.waypoints().stream().collect(Collectors.toMap(Waypoint::id, Waypoint::place));
        return plan.unserved().stream()
                .flatMap(one -> Stream.ofNullable(places.get(one.waypoint()))
                        .map(place -> new PlanView.UnservedView(one.waypoint(), one.why(), place(place))))
                .toList();
    }

    private static PlanView.TourView tour(PlanJobInput order, Craft craft, Tour tour) {
        double range = craft.supply().rangeJoules();
        return new PlanView.TourView(
                tour.drone().value(),
                order.nameOf(tour.drone()),
                tour.departsSeconds(),
                tour.endsSeconds(),
                tour.ways().stream().mapToDouble(PlanViewMapper::meters).sum(),
                tour.usedJoules() / JOULES_PER_WATT_HOUR,
                Double.isInfinite(range) || range == 0 ? null : Double.valueOf(tour.usedJoules() / range),
                tour.stops().stream().map(PlanViewMapper::stop).toList(),
                tour.last().fixes().stream()
                        .skip(1)
                        .map(fix -> place(fix.place()))
                        .toList());
    }

    private static PlanView.StopView stop(TourStop stop) {
        Place place = stop.way().to();
        return new PlanView.StopView(
                stop.waypoint(),
                place.point().latitudeDegrees(),
                place.point().longitudeDegrees(),
                place.altitudeAmslMeters(),
                stop.arrivesSeconds(),
                stop.beginsSeconds(),
                stop.leavesSeconds(),
                stop.usedJoules() / JOULES_PER_WATT_HOUR,
                stop.way().via().stream().map(PlanViewMapper::place).toList());
    }

    private static PlanView.PlaceView place(Place place) {
        return new PlanView.PlaceView(
                place.point().latitudeDegrees(), place.point().longitudeDegrees(), place.altitudeAmslMeters());
    }

    static double meters(TourLeg way) {
        double meters = 0;
        List<TimedPlace> fixes = way.fixes();
        for (int i = 0; i + 1 < fixes.size(); i++) {
            meters += HERE.distanceMeters(LocalPlane.offset(
                    fixes.get(i).place().point(), fixes.get(i + 1).place().point()));
        }
        return meters;
    }

    private static PlanView.@Nullable LaunchView launch(PlanJobInput order, PlanJob.Status status) {
        return status.flights().isEmpty()
                ? null
                : new PlanView.LaunchView(
                        status.busy(),
                        status.flights().stream()
                                .map(flight -> flight(order, flight))
                                .toList());
    }

    private static PlanView.DroneLaunchView flight(PlanJobInput order, DroneLaunchStatus flight) {
        return new PlanView.DroneLaunchView(
                flight.drone().value(),
                order.nameOf(flight.drone()),
                WireNames.camel(flight.stage()),
                flight.why() == null ? null : flight.why().sentence(),
                flight.why() == null ? null : flight.why().code(),
                flight.command());
    }
}
