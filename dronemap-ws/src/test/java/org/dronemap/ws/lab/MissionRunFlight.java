package org.dronemap.ws.lab;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.plan.PlanObjectiveRequest;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanTaskRequest;
import org.dronemap.ws.plan.PlanView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.run.RunRequest;
import org.dronemap.ws.run.RunView;
import org.jspecify.annotations.Nullable;

/** A mission run of some drones, as its pilot sees it and as it truly is flown. */
public final class MissionRunFlight {
    private static final Duration LONGEST_PLAN = Duration.ofSeconds(60);
    private static final Duration LONGEST_RUN = Duration.ofMinutes(20);
    private static final double PLAN_SECONDS = 1;

    private final Laboratory lab;
    private final Pilot pilot;
    private final List<LabDrone> drones;
    private final String id;

    /** How it is flown; {@code searchSeconds} null: as usual. */
    public record Manner(
            String mode, String onCloudLoss, @Nullable Double searchSeconds) {
        public static final Manner ON = new Manner("automatic", "continue", null);
    }

    private MissionRunFlight(Laboratory lab, Pilot pilot, List<LabDrone> drones, String id) {
        this.lab = lab;
        this.pilot = pilot;
        this.drones = new ArrayList<>(drones);
        this.id = id;
    }

    /** Plans it for all of them, and begins. */
    public static MissionRunFlight begins(
            Laboratory lab,
            Pilot pilot,
            List<LabDrone> drones,
            List<PlanRequest.WaypointRequest> waypoints,
            Manner manner) {
        return begins(lab, pilot, drones, planned(lab, pilot, drones, waypoints), manner);
    }

    /** The same before they are ready to arm: as soon as a plan for them is taken. */
    public static MissionRunFlight beginsAtOnce(
            Laboratory lab,
            Pilot pilot,
            List<LabDrone> drones,
            List<PlanRequest.WaypointRequest> waypoints,
            Manner manner) {
        PlanView asked = lab.untilSeen("a plan is taken", LONGEST_PLAN, () -> {
            try {
                return Optional.of(ask(lab, pilot, drones, waypoints));
            } catch (Rejection notYet) {
                return Optional.empty();
            }
        });
        return begins(lab, pilot, drones, finished(lab, pilot, asked), manner);
    }

    /** Begins with a plan that has been found. */
    public static MissionRunFlight begins(
            Laboratory lab, Pilot pilot, List<LabDrone> drones, PlanView plan, Manner manner) {
        RunRequest.StartRequest request = new RunRequest.StartRequest(
                plan.id(), manner.mode(), manner.onCloudLoss(), "roofs", manner.searchSeconds());
        RunView begun = lab.server().runs().start(pilot.principal(), request);
        return new MissionRunFlight(lab, pilot, drones, begun.id());
    }

    /** A plan in which every drone flies, once it is found. */
    public static PlanView planned(
            Laboratory lab, Pilot pilot, List<LabDrone> drones, List<PlanRequest.WaypointRequest> waypoints) {
        drones.forEach(drone -> lab.until(drone.name() + " can be planned for", LONGEST_PLAN, drone::isPlannable));
        return finished(lab, pilot, ask(lab, pilot, drones, waypoints));
    }

    private static PlanView ask(
            Laboratory lab, Pilot pilot, List<LabDrone> drones, List<PlanRequest.WaypointRequest> waypoints) {
        PlanRequest request = new PlanRequest(
                waypoints.stream().toList(),
                drones.stream().map(drone -> drone.id().value()).toList(),
                null,
                new PlanObjectiveRequest.EarliestEnd(true),
                PLAN_SECONDS,
                null,
                null);
        return lab.server().plans().ask(pilot.principal(), request);
    }

    /** By up to so many drones of the pool; {@code drones}: all that may come to fly it. */
    public static MissionRunFlight beginsWithPool(
            Laboratory lab, Pilot pilot, List<LabDrone> drones, int upTo, List<PlanRequest.WaypointRequest> waypoints) {
        return begins(lab, pilot, drones, plannedForPool(lab, pilot, upTo, waypoints), Manner.ON);
    }

    /** Begins what was planned. */
    public static MissionRunFlight begins(Laboratory lab, Pilot pilot, List<LabDrone> drones, PlanView plan) {
        return begins(lab, pilot, drones, plan, Manner.ON);
    }

    public static PlanView plannedForPool(
            Laboratory lab, Pilot pilot, int upTo, List<PlanRequest.WaypointRequest> waypoints) {
        PlanRequest request = new PlanRequest(
                waypoints.stream().toList(),
                null,
                upTo,
                new PlanObjectiveRequest.EarliestEnd(false),
                PLAN_SECONDS,
                null,
                null);
        return finished(lab, pilot, lab.server().plans().ask(pilot.principal(), request));
    }

    private static PlanView finished(Laboratory lab, Pilot pilot, PlanView asked) {
        return lab.untilSeen(
                "the plan is finished",
                LONGEST_PLAN,
                () -> Optional.of(lab.server().plans().one(pilot.principal(), asked.id()))
                        .filter(plan -> plan.state().equals("finished")));
    }

    /** At that place, so high above the sea. */
    public static PlanRequest.WaypointRequest waypoint(Geodetic place, double amsl) {
        return waypoint(place, amsl, null, null);
    }

    /** The same with what is done there. */
    public static PlanRequest.WaypointRequest waypoint(
            Geodetic place, double amsl, @Nullable Double holdSeconds, @Nullable List<PlanTaskRequest> tasks) {
        return new PlanRequest.WaypointRequest(
                null,
                place.latitudeDegrees(),
                place.longitudeDegrees(),
                amsl,
                "amsl",
                holdSeconds,
                null,
                null,
                null,
                tasks == null ? null : tasks.stream().toList());
    }

    public String id() {
        return id;
    }

    /** One more drone takes part. */
    public void joins(LabDrone drone) {
        drones.add(drone);
        var unused = lab.server()
                .runs()
                .join(
                        pilot.principal(),
                        id,
                        new RunRequest.JoinRequest(drone.id().value()));
    }

    public RunView view() {
        return lab.server().runs().one(pilot.principal(), id);
    }

    /** By the id of each drone. */
    public Map<String, String> stages() {
        return view().drones().stream().collect(Collectors.toMap(RunView.DroneView::id, RunView.DroneView::stage));
    }

    public String stage(LabDrone drone) {
        return stages().get(drone.id().value());
    }

    public boolean allAre(String stage) {
        return view().drones().stream().allMatch(drone -> drone.stage().equals(stage));
    }

    public MissionRunFlight awaitsAll(String stage) {
        lab.untilSeen("all are " + stage, Duration.ofMinutes(4), () -> allAre(stage));
        return this;
    }

    /** Waits for its end. */
    public RunView end() {
        return lab.untilSeen(
                "the run is over",
                LONGEST_RUN,
                () -> Optional.of(view()).filter(run -> run.state().equals("over")));
    }

    public RunView.WaypointView waypoint(String waypoint) {
        return view().waypoints().stream()
                .filter(one -> one.id().equals(waypoint))
                .findFirst()
                .orElseThrow();
    }

    /** The waypoints ahead of that drone, by their ids. */
    public List<String> next(LabDrone drone) {
        return view().drones().stream()
                .filter(one -> one.id().equals(drone.id().value()))
                .findFirst()
                .map(RunView.DroneView::next)
                .orElse(List.of());
    }

    /** That drone's waypoints in that state. */
    public List<String> of(LabDrone drone, String state) {
        String own = drone.id().value();
        return view().waypoints().stream()
                .filter(one -> one.state().equals(state))
                .filter(one -> Stream.concat(
                                Stream.ofNullable(one.drone()),
                                one.visits().stream().map(RunView.VisitView::drone))
                        .anyMatch(own::equals))
                .map(RunView.WaypointView::id)
                .toList();
    }

    /** Its explanations for that reason. */
    public List<RunView.ExplanationView> told(String trigger) {
        return view().explanations().stream()
                .filter(one -> one.trigger().equals(trigger))
                .toList();
    }

    public LabDrone drone(String drone) {
        return drones.stream()
                .filter(one -> one.id().value().equals(drone))
                .findFirst()
                .orElseThrow(() -> new AssertionError("It is none of this run: " + drone));
    }

    /** How near the drone that is said to have visited it truly came, in m, height included. */
    public double missed(RunView.WaypointView waypoint) {
        LabDrone drone = drone(waypoint.visits().get(0).drone());
        return drone.track().nearest(place(waypoint), waypoint.altitudeAmsl());
    }

    public static Geodetic place(RunView.WaypointView waypoint) {
        return new Geodetic(waypoint.latitude(), waypoint.longitude());
    }

    /** Whether its journal bears itself out. */
    public boolean decidesTheSameAgain() {
        return lab.server().journals().replay(pilot.principal(), id).same();
    }
}
