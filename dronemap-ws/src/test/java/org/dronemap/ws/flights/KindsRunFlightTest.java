package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.WingedSpecs;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanTaskRequest;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Mission runs in which no vehicle is lost because it was not ready yet, or is of another kind. */
class KindsRunFlightTest {
    private final Laboratory lab = new Laboratory(1);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private static void requireAllVisited(RunView over, int waypoints) {
        assertThat(over.counts().visited()).as("%s", over.explanations()).isEqualTo(waypoints);
    }

    @Test
    void fourCoptersThatHaveJustBeenSwitchedOn() {
        List<LabDrone> copters = IntStream.range(0, 4)
                .mapToObj(number -> lab.add(VehicleSpec.COPTER.readyAfter(20 + 5 * number)))
                .toList();
        LabDrone first = copters.get(0);
        double amsl = first.groundAmsl() + 20;
        PlanTaskRequest look = new PlanTaskRequest.LookAt(
                first.place(60, 40).latitudeDegrees(), first.place(60, 40).longitudeDegrees(), first.groundAmsl());
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 8)
                .mapToObj(n -> MissionRunFlight.waypoint(
                        first.place(40 + 25 * (n / 4), 25 * (n % 4)), amsl, null, List.of(look)))
                .toList();
        copters.forEach(copter -> lab.until(
                "it is heard", Duration.ofSeconds(30), () -> copter.known().isPresent()));
        MissionRunFlight run =
                MissionRunFlight.beginsAtOnce(lab, chief, copters, waypoints, MissionRunFlight.Manner.ON);
        assertThat(copters)
                .anyMatch(copter -> !Boolean.TRUE.equals(copter.state().readyToArm()));

        RunView over = run.end();

        requireAllVisited(over, 8);
        assertThat(run.allAre("landed")).isTrue();
        assertThat(over.waypoints())
                .allSatisfy(one -> assertThat(run.missed(one)).isLessThan(4));
        lab.until("all are down", Duration.ofMinutes(3), () -> copters.stream().allMatch(LabDrone::isDown));
    }

    @Test
    void aCopterARoverAndAPlane() {
        List<LabDrone> drones = Stream.of(VehicleSpec.COPTER, VehicleSpec.ROVER, WingedSpecs.PLANE)
                .map(lab::add)
                .toList();
        drones.forEach(lab::ready);
        LabDrone first = drones.get(0);
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 3)
                .mapToObj(n -> MissionRunFlight.waypoint(first.place(150 + 60 * n, 40 * n), first.groundAmsl() + 60))
                .toList();

        MissionRunFlight run = MissionRunFlight.begins(lab, chief, drones, waypoints, MissionRunFlight.Manner.ON);

        RunView over = run.end();
        requireAllVisited(over, 3);
        assertThat(drones).allMatch(drone -> drone.track().strayed(0) > 100);
        assertThat(drones.subList(0, 2))
                .extracting(run::stage)
                .as("the copter and the rover")
                .containsOnly("landed");
        assertThat(over.drones().get(2).note()).as("no run lands a plane").contains("circles over its home");
        assertThat(run.decidesTheSameAgain()).isTrue();
    }
}
