package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.VehicleTrack;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanView;
import org.junit.jupiter.api.Test;

/** A mission of several drones, planned and flown by three calls. */
class DroneLaunchStatusTest {
    private static final int WAYPOINTS = 12;
    private static final double SPACING_METERS = 45;
    private static final double HEIGHT_METERS = 25;
    private static final double NEAR_METERS = 3;
    private static final double NEAR_HEIGHT_METERS = 2;

    @Test
    void threeDronesFlyTwelveWaypointsByThreeCalls() {
        try (Laboratory lab = new Laboratory(1)) {
            List<LabDrone> drones = lab.copters(3);
            Pilot ann = lab.pilot("ann", Role.OPERATOR);

            PlanView plan = MissionRunFlight.planned(lab, ann, drones, waypoints(drones.get(0)));

            PlanView.ResultView result = Objects.requireNonNull(plan.result());
            assertThat(result.faults()).isEmpty();
            assertThat(result.unserved()).isEmpty();
            assertThat(result.tours()).hasSize(drones.size());
            assertThat(result.tours().stream()
                            .flatMap(tour -> tour.stops().stream())
                            .map(PlanView.StopView::waypoint))
                    .containsExactlyInAnyOrderElementsOf(IntStream.rangeClosed(1, WAYPOINTS)
                            .mapToObj(Integer::toString)
                            .toList());

            starts(lab, ann, plan);
            lab.untilSeen(
                    "all have started",
                    Duration.ofMinutes(2),
                    () -> stages(lab, ann, plan).equals(List.of("started", "started", "started")));
            lab.until(
                    "all are home", Duration.ofMinutes(5), () -> drones.stream().allMatch(LabDrone::isDown));
            requireVisits(drones, result);
        }
    }

    @Test
    void nobodyIsStartedBelowAnotherOneThatHoversThere() {
        try (Laboratory lab = new Laboratory(2)) {
            LabDrone starts = lab.copter();
            LabDrone hovers =
                    lab.ready(lab.add(VehicleSpec.COPTER, new LocalFrame(47.3977, 8.5456 + 3 / 75_300.0, 488)));
            Pilot ann = lab.pilot("ann", Role.OPERATOR);
            Pilot bob = lab.pilot("bob", Role.OPERATOR);
            PlanView plan = MissionRunFlight.planned(lab, ann, List.of(starts), waypoints(starts));
            bob.takesOff(hovers, 15);
            lab.until("it hovers", Duration.ofMinutes(1), () -> hovers.height() > 14);

            starts(lab, ann, plan);
            lab.untilSeen(
                    "it waits",
                    Duration.ofMinutes(1),
                    () -> stages(lab, ann, plan).equals(List.of("waiting")));
            lab.throughout(
                    "it is not armed",
                    Duration.ofSeconds(20),
                    () -> !starts.craft().armed());

            bob.fliesTo(hovers, hovers.place(0, 60), 15);
            lab.untilSeen(
                    "it has started",
                    Duration.ofMinutes(1),
                    () -> stages(lab, ann, plan).equals(List.of("started")));
            assertThat(hovers.distanceTo(starts.place(0, 0))).isGreaterThan(20);
        }
    }

    private static void starts(Laboratory lab, Pilot ann, PlanView plan) {
        var unused = lab.server()
                .plans()
                .accept(
                        new Caller(ann.principal(), "laboratory"),
                        plan.id(),
                        new PlanRequest.AcceptRequest(true, null),
                        Duration.ZERO);
    }

    private static PlanView.DroneLaunchView first(Laboratory lab, Pilot ann, PlanView plan) {
        PlanView.LaunchView launch = Objects.requireNonNull(
                lab.server().plans().one(ann.principal(), plan.id()).launch());
        return launch.drones().get(0);
    }

    /** Four by three, west of a home. */
    private static List<PlanRequest.WaypointRequest> waypoints(LabDrone first) {
        double amsl = first.groundAmsl() + HEIGHT_METERS;
        return IntStream.range(0, WAYPOINTS)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        first.place((n % 4 - 1) * SPACING_METERS, -(1 + n / 4) * SPACING_METERS), amsl))
                .toList();
    }

    /** Who was to go there goes there; on its way it may come by where others were. */
    private static void requireVisits(List<LabDrone> drones, PlanView.ResultView result) {
        Map<String, LabDrone> byId =
                drones.stream().collect(Collectors.toMap(drone -> drone.id().value(), Function.identity()));
        for (PlanView.TourView tour : result.tours()) {
            for (PlanView.StopView stop : tour.stops()) {
                assertThat(came(byId.get(tour.drone()), stop))
                        .as(tour.name() + " at waypoint " + stop.waypoint())
                        .isTrue();
            }
        }
    }

    private static List<String> stages(Laboratory lab, Pilot ann, PlanView plan) {
        List<String> stages =
                Objects.requireNonNull(lab.server()
                                .plans()
                                .one(ann.principal(), plan.id())
                                .launch())
                        .drones()
                        .stream()
                        .map(PlanView.DroneLaunchView::stage)
                        .toList();
        assertThat(stages).doesNotContain("failed");
        return stages;
    }

    private static boolean came(LabDrone drone, PlanView.StopView stop) {
        Geodetic place = new Geodetic(stop.latitude(), stop.longitude());
        for (VehicleTrack.Fix fix : drone.track().since(0)) {
            if (Math.abs(fix.amsl() - stop.altitudeAmsl()) < NEAR_HEIGHT_METERS
                    && Geodesy.distanceMeters(fix.place(), place) < NEAR_METERS) {
                return true;
            }
        }
        return false;
    }
}
