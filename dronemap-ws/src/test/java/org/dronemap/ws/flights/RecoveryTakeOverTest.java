package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.dispatch.DispatchRequest;
import org.dronemap.ws.dispatch.DispatchView;
import org.dronemap.ws.follow.FollowRequest.PlaceRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SimulatedPhone;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.lab.WingedSpecs;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.recovery.RecoveryPreview;
import org.dronemap.ws.recovery.RecoveryRequest;
import org.dronemap.ws.recovery.RecoveryView;
import org.dronemap.ws.run.RunView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Drones that other operations have come home together: those end by their own rules, and nobody stays in the air. */
class RecoveryTakeOverTest {
    private static final Duration LONGEST = Duration.ofMinutes(10);
    private static final RecoveryRequest ALL = new RecoveryRequest("return", null, null, null, null, null);
    private static final RecoveryRequest TAKING = new RecoveryRequest("return", null, null, null, true, null);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private RecoveryView begins() {
        return lab.server().recoveries().begin(ann.principal(), TAKING);
    }

    private RecoveryPreview.LeftOutView leftOut(LabDrone drone) {
        return lab.server().recoveries().preview(ann.principal(), ALL).leftOut().stream()
                .filter(one -> one.drone().equals(drone.id().value()))
                .findFirst()
                .orElseThrow();
    }

    private void bringsAllDown(RecoveryView begun, List<LabDrone> drones, Separation apart) {
        lab.untilSeen("the recovery is over", LONGEST, () -> {
            apart.look();
            return lab.server()
                    .recoveries()
                    .one(ann.principal(), begun.id())
                    .state()
                    .equals("over");
        });
        RecoveryView over = lab.server().recoveries().one(ann.principal(), begun.id());
        assertThat(over.end()).isEqualTo("All are down.");
        assertThat(over.drones()).hasSize(drones.size()).allMatch(leg -> "down".equals(leg.outcome()));
        assertThat(drones).allMatch(drone -> drone.isDown() && drone.away() < 3);
        assertThat(apart.least()).as(apart.words()).isGreaterThan(1);
        for (LabDrone drone : drones) {
            assertThat(ann.control(drone).state()).isEqualTo("free");
        }
    }

    /** One that nobody has, so that a preview has something to show. */
    private LabDrone anotherAloft() {
        LabDrone another = lab.ready(lab.add(VehicleSpec.COPTER));
        ann.takesOff(another, 30);
        return another;
    }

    @Test
    void aMissionRunIsStoppedAndItsDronesComeHomeWithTheOthers() {
        List<LabDrone> drones = lab.copters(3);
        LabDrone first = drones.get(0);
        List<PlanRequest.WaypointRequest> waypoints = IntStream.range(0, 9)
                .mapToObj(n ->
                        MissionRunFlight.waypoint(first.place((2 + n % 3) * 40, (n / 3) * 30), first.groundAmsl() + 20))
                .toList();
        MissionRunFlight run = MissionRunFlight.begins(lab, ann, drones, waypoints, MissionRunFlight.Manner.ON)
                .awaitsAll("flying");
        lab.until("all are up", Duration.ofMinutes(1), () -> drones.stream().allMatch(drone -> drone.height() > 10));

        RecoveryView begun = begins();
        assertThat(ann.control(first).holder()).contains("The recovery");
        Separation apart = new Separation(drones);
        bringsAllDown(begun, drones, apart);

        RunView over = run.end();
        assertThat(over.state()).isEqualTo("over");
        assertThat(over.explanations())
                .extracting(RunView.ExplanationView::trigger)
                .contains("stopped");
        assertThat(over.waypoints()).anyMatch(one -> one.state().equals("unserved"));
        assertThat(run.decidesTheSameAgain()).isTrue();
        lab.until(
                "what their owners had set is put back, not what the run had",
                Duration.ofMinutes(1),
                () -> drones.stream()
                        .allMatch(drone ->
                                drone.vehicle().autopilot().parameters().value("RTL_ALT") == 1_500));
    }

    @Test
    void aFollowEndsAndItsDroneComesHomeWithTheOthers() {
        LabDrone copter = lab.copter();
        LabDrone another = anotherAloft();
        SimulatedPhone phone = lab.phone(ann, copter, 40, 0);
        phone.asks(copter, new PlaceRequest("fixed", 180.0, null, 8.0, 12.0), 60)
                .starts();
        phone.awaits("tracking", Duration.ofMinutes(1));
        RecoveryPreview.LeftOutView left = leftOut(copter);
        assertThat(left.code()).isEqualTo("recovery-needs-take-over");
        assertThat(left.why()).contains("follow", "Ask with takeOver to take it over.");

        RecoveryView begun = begins();
        bringsAllDown(begun, List.of(copter, another), new Separation(List.of(copter, another)));

        phone.awaits("over", Duration.ofMinutes(1));
    }

    @Test
    void aDispatchIsCalledOffAndItsDroneComesHomeWithTheOthers() {
        Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
        LabDrone sent = lab.copter();
        LabDrone another = anotherAloft();
        lab.server().warehouse().put(chief.principal(), sent.id().value());
        Geodetic place = sent.place(150, -40);
        DispatchView dispatch = lab.server()
                .dispatches()
                .send(
                        ann.principal(),
                        new DispatchRequest(place.latitudeDegrees(), place.longitudeDegrees(), 25.0, null));
        lab.untilSeen(
                "it is on its way",
                Duration.ofMinutes(2),
                () -> view(dispatch).state().equals("enRoute"));
        assertThat(leftOut(sent).code()).isEqualTo("recovery-needs-take-over");

        RecoveryView begun = begins();
        bringsAllDown(begun, List.of(sent, another), new Separation(List.of(sent, another)));

        lab.untilSeen(
                "the dispatch is over",
                Duration.ofMinutes(1),
                () -> view(dispatch).state().equals("over"));
    }

    private DispatchView view(DispatchView sent) {
        return lab.server().dispatches().one(ann.principal(), sent.id());
    }

    @Test
    void aPlaneIsLeftAloneAndItIsSaidHowItComesHome() {
        LabDrone plane = lab.ready(lab.add(WingedSpecs.PLANE));
        ann.does(plane, CommandRequests.setMode("TAKEOFF")).does(plane, CommandRequests.arm());
        lab.until("it is up", Duration.ofMinutes(1), () -> plane.height() > 45);
        anotherAloft();
        for (String manner : List.of("return", "land")) {
            RecoveryPreview preview = lab.server()
                    .recoveries()
                    .preview(ann.principal(), new RecoveryRequest(manner, null, null, null, true, null));
            assertThat(preview.drones()).hasSize(1);
            assertThat(preview.leftOut()).singleElement().satisfies(left -> {
                assertThat(left.drone()).isEqualTo(plane.id().value());
                assertThat(left.code()).isEqualTo("recovery-not-for-kind");
                assertThat(left.why())
                        .isEqualTo(
                                "A plane does not stand in the air until its turn comes. Once the others are down, send"
                                        + " it home by itself: return to launch.");
            });
        }
    }
}
