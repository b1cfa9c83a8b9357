package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.plan.PlanView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A mission for up to n drones of the pool, which the cloud chooses, and replaces when they are lost. */
class PoolRunFlightTest {
    private static final double SERVED_METERS = 2;

    private final Laboratory lab = new Laboratory(1);
    private final Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
    private final List<LabDrone> copters = lab.copters(3);

    @AfterEach
    void close() {
        lab.close();
    }

    private void lends(LabDrone... drones) {
        for (LabDrone drone : drones) {
            lab.until("it can be planned for", Duration.ofSeconds(60), () -> isHeardWell(drone));
            lab.server().warehouse().put(chief.principal(), drone.id().value());
        }
    }

    private static boolean isHeardWell(LabDrone drone) {
        return drone.known()
                .filter(state -> state.link().quality().lossShort() != null && state.battery() != null)
                .isPresent();
    }

    private List<PlanRequest.WaypointRequest> waypoints() {
        LabDrone first = copters.get(0);
        return IntStream.range(0, 4)
                .mapToObj(n -> MissionRunFlight.waypoint(first.place(30 + 30 * n, -20), first.groundAmsl() + 20))
                .toList();
    }

    private static double nearest(LabDrone drone, PlanRequest.WaypointRequest to) {
        Geodetic place = new Geodetic(Objects.requireNonNull(to.latitude()), Objects.requireNonNull(to.longitude()));
        return drone.track().nearest(place, Objects.requireNonNull(to.altitude()));
    }

    private static void requireAllVisited(RunView over) {
        assertThat(over.counts().visited()).isEqualTo(4);
        assertThat(over.end()).contains("all 4 waypoints visited");
    }

    @Test
    void theNearestDronesOfThePoolFlyIt() {
        lends(copters.get(0), copters.get(2));
        MissionRunFlight run = MissionRunFlight.beginsWithPool(lab, chief, copters, 1, waypoints());
        assertThat(run.view().upTo()).isEqualTo(1);
        assertThat(run.view().drones())
                .extracting(RunView.DroneView::id)
                .containsExactly(copters.get(0).id().value());
        requireAllVisited(run.end());
        assertThat(copters.get(2).isDown()).isTrue();
        assertThat(run.decidesTheSameAgain()).isTrue();
    }

    @Test
    void aDroneThatIsLostAtTakeOffIsReplacedByAnother() {
        lends(copters.get(0), copters.get(1));
        MissionRunFlight run = MissionRunFlight.beginsWithPool(lab, chief, copters, 1, waypoints());
        lab.until("it takes off", Duration.ofMinutes(2), () -> copters.get(0).height() > 1);
        copters.get(0).craft().failMotor();

        RunView over = run.end();
        requireAllVisited(over);
        assertThat(run.told("joined"))
                .anyMatch(one -> one.words()
                        .contains("of the pool joins. " + copters.get(0).state().name()));
        assertThat(over.drones()).hasSize(2);
        assertThat(over.waypoints())
                .allSatisfy(one -> assertThat(run.missed(one)).isLessThan(5));
        LabDrone other = copters.get(1);
        assertThat(waypoints())
                .allSatisfy(place -> assertThat(nearest(other, place)).isLessThan(SERVED_METERS));
        assertThat(waypoints())
                .allSatisfy(place -> assertThat(nearest(copters.get(0), place)).isGreaterThan(SERVED_METERS));
        assertThat(run.decidesTheSameAgain()).isTrue();
    }

    @Test
    void aDroneThatIsNotFreeAtTheStartIsReplacedBeforeIt() {
        lends(copters.get(0), copters.get(1));
        PlanView plan = MissionRunFlight.plannedForPool(lab, chief, 1, waypoints());
        assertThat(plan.upTo()).isEqualTo(1);
        lab.pilot("bob", Role.OPERATOR).takesControl(copters.get(0));
        MissionRunFlight run = MissionRunFlight.begins(lab, chief, copters, plan);
        assertThat(run.view().drones())
                .extracting(RunView.DroneView::id)
                .containsExactly(copters.get(1).id().value());
    }

    @Test
    void withoutAnotherOneTheRunEndsAndSaysWhy() {
        lends(copters.get(0));
        MissionRunFlight run = MissionRunFlight.beginsWithPool(lab, chief, copters, 2, waypoints());
        lab.until("it takes off", Duration.ofMinutes(2), () -> copters.get(0).height() > 1);
        copters.get(0).craft().failMotor();
        RunView over = run.end();
        assertThat(over.counts().visited()).isZero();
        assertThat(run.told("lost"))
                .extracting(RunView.ExplanationView::words)
                .containsExactly("No other drone of the pool can join. The pool has no other drone for you.");
    }

    @Test
    void aPlanIsForNamedDronesOrForThePool() {
        Rejection none = catchThrowableOfType(
                Rejection.class, () -> MissionRunFlight.plannedForPool(lab, chief, 2, waypoints()));
        assertThat(none.sentence()).startsWith("No drone of the pool can be planned with now.");
    }
}
