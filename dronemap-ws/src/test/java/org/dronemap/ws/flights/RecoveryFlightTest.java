package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.recovery.RecoveryPreview;
import org.dronemap.ws.recovery.RecoveryRequest;
import org.dronemap.ws.recovery.RecoveryView;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Several drones come home, or down, as one operation, as it is shown and as they truly fly. */
class RecoveryFlightTest {
    private static final long RTL = 6;
    private static final long LOITER = 5;
    private static final double PADS_METERS = 12;
    private static final double HEIGHT = 25;
    private static final Duration LONGEST = Duration.ofMinutes(14);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    /** In a row, as near to each other as on a field; each flies to a place at its height. */
    private List<LabDrone> inTheAir(int count) {
        List<LabDrone> drones = IntStream.range(0, count)
                .mapToObj(i ->
                        lab.add(VehicleSpec.COPTER, LabDrone.FIELD.shifted(new NeuPosition(0, i * PADS_METERS, 0))))
                .toList();
        drones.forEach(lab::ready);
        for (int i = 0; i < count; i++) {
            ann.takesOff(drones.get(i), HEIGHT + i);
        }
        for (int i = 0; i < count; i++) {
            ann.fliesTo(drones.get(i), place(drones, count - 1 - i), HEIGHT + i);
        }
        lab.until(
                "all are there",
                Duration.ofMinutes(2),
                () -> IntStream.range(0, count)
                        .allMatch(i -> drones.get(i).distanceTo(place(drones, count - 1 - i)) < 3));
        return drones;
    }

    /** North of the row, the other way round: their ways home cross. */
    private static Geodetic place(List<LabDrone> drones, int number) {
        return drones.get(0).place(60, number * 22 - 40);
    }

    private static RecoveryRequest all(String manner) {
        return new RecoveryRequest(manner, null, null, null, null, null);
    }

    private RecoveryView begins(RecoveryRequest request) {
        return lab.server().recoveries().begin(ann.principal(), request);
    }

    private RecoveryView view(RecoveryView begun) {
        return lab.server().recoveries().one(ann.principal(), begun.id());
    }

    private RecoveryView awaitsEnd(RecoveryView begun, Separation apart) {
        lab.untilSeen("it is over", LONGEST, () -> {
            apart.look();
            return view(begun).state().equals("over");
        });
        return view(begun);
    }

    private static RecoveryView.LegView leg(RecoveryView view, LabDrone drone) {
        return view.drones().stream()
                .filter(leg -> leg.drone().equals(drone.id().value()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void eightWhoseWaysCrossComeHomeApartFromEachOther() {
        List<LabDrone> drones = inTheAir(8);
        RecoveryPreview preview = lab.server().recoveries().preview(ann.principal(), all("return"));
        assertThat(preview.drones()).hasSize(8);
        assertThat(preview.leftOut()).isEmpty();
        assertThat(preview.seconds()).isBetween(100.0, 700.0);
        double[] heights = preview.drones().stream()
                .mapToDouble(one -> Objects.requireNonNull(one.plan()).height())
                .sorted()
                .toArray();
        for (int i = 1; i < heights.length; i++) {
            assertThat(heights[i] - heights[i - 1]).isGreaterThanOrEqualTo(5.9);
        }

        RecoveryView begun = begins(all("return"));
        assertThat(begun.state()).isEqualTo("stopping");
        Separation apart = new Separation(drones);
        RecoveryView over = awaitsEnd(begun, apart);

        assertThat(over.end()).isEqualTo("All are down.");
        assertThat(over.drones()).allMatch(leg -> "down".equals(leg.outcome()));
        assertThat(drones).allMatch(drone -> drone.isDown() && drone.away() < 3);
        assertThat(apart.least()).as(apart.words()).isGreaterThan(1);
        // What their owners had set is there again.
        lab.until(
                "their return heights are put back",
                Duration.ofMinutes(1),
                () -> drones.stream()
                        .allMatch(drone ->
                                drone.vehicle().autopilot().parameters().value("RTL_ALT") == 1_500));
        assertThat(ann.control(drones.get(0)).state()).isEqualTo("free");
    }

    @Test
    void eachLandsWhereItIsAndNearOnesOneAfterTheOther() {
        List<LabDrone> drones = inTheAir(4);
        ann.fliesTo(drones.get(0), drones.get(1).where(), HEIGHT + 12);
        lab.goOn(Duration.ofSeconds(20));
        ann.fliesTo(drones.get(0), drones.get(0).place(60, 12), HEIGHT + 12);
        lab.goOn(Duration.ofSeconds(20));
        RecoveryPreview preview = lab.server().recoveries().preview(ann.principal(), all("land"));
        RecoveryView begun = begins(all("land"));
        Separation apart = new Separation(drones);
        RecoveryView over = awaitsEnd(begun, apart);

        assertThat(over.end()).isEqualTo("All are down.");
        assertThat(apart.least()).as(apart.words()).isGreaterThan(1);
        for (RecoveryPreview.PlannedView one : preview.drones()) {
            LabDrone drone = drones.stream()
                    .filter(each -> each.id().value().equals(one.drone()))
                    .findFirst()
                    .orElseThrow();
            RecoveryView.PartView plan = Objects.requireNonNull(one.plan());
            assertThat(drone.distanceTo(new Geodetic(plan.latitude(), plan.longitude())))
                    .isLessThan(4);
            assertThat(drone.isDown()).isTrue();
        }
    }

    @Test
    void oneThatIsNotHeardIsToldSoAndTheOthersComeHome() {
        List<LabDrone> drones = inTheAir(4);
        RecoveryView begun = begins(all("return"));
        lab.untilSeen(
                "they come home",
                Duration.ofSeconds(40),
                () -> view(begun).state().equals("comingDown"));
        lab.goOn(Duration.ofSeconds(2));
        drones.get(1).wire().cut();
        Separation apart = new Separation(drones);
        lab.untilSeen("it is noted", Duration.ofSeconds(20), () -> {
            apart.look();
            return String.valueOf(leg(view(begun), drones.get(1)).note()).contains("no contact");
        });
        lab.untilSeen("the others are down", LONGEST, () -> {
            apart.look();
            return drones.stream().filter(drone -> drone != drones.get(1)).allMatch(LabDrone::isDown);
        });
        assertThat(view(begun).state()).isEqualTo("comingDown");
        drones.get(1).wire().mend();
        RecoveryView over = awaitsEnd(begun, apart);
        assertThat(leg(over, drones.get(1)).outcome()).isEqualTo("down");
        assertThat(drones).allMatch(drone -> drone.isDown() && drone.away() < 3);
        assertThat(apart.least()).as(apart.words()).isGreaterThan(1);
    }

    @Test
    void aRestartInTheMiddleIsNoEndOfIt() {
        List<LabDrone> drones = inTheAir(5);
        RecoveryView begun = begins(all("return"));
        Separation apart = new Separation(drones);
        for (int crash = 0; crash < 3; crash++) {
            lab.untilSeen("some time", Duration.ofSeconds(60), new Looks(apart, 90)::isDone);
            lab.crashServer();
            lab.goOn(Duration.ofSeconds(2));
            lab.startServer();
        }
        RecoveryView over = awaitsEnd(begun, apart);
        assertThat(over.drones()).allMatch(leg -> "down".equals(leg.outcome()));
        assertThat(drones).allMatch(drone -> drone.isDown() && drone.away() < 3);
        assertThat(apart.least()).as(apart.words()).isGreaterThan(1);
    }

    /** So many looks, ten a second. */
    private static final class Looks {
        private final Separation apart;
        private int left;

        Looks(Separation apart, int left) {
            this.apart = apart;
            this.left = left;
        }

        boolean isDone() {
            apart.look();
            left--;
            return left < 0;
        }
    }

    @Test
    void calledOffTheyHoldAndAreTheAskersAgain() {
        List<LabDrone> drones = inTheAir(3);
        RecoveryView begun = begins(all("return"));
        lab.untilSeen(
                "they come home",
                Duration.ofSeconds(40),
                () -> view(begun).state().equals("comingDown"));
        lab.goOn(Duration.ofSeconds(6));
        RecoveryView off = lab.server().recoveries().cancel(ann.principal(), begun.id());
        assertThat(off.state()).isEqualTo("givingBack");
        Separation apart = new Separation(drones);
        RecoveryView over = awaitsEnd(begun, apart);
        assertThat(over.drones()).allMatch(leg -> "givenBack".equals(leg.outcome()));
        for (LabDrone drone : drones) {
            assertThat(drone.isDown()).isFalse();
            assertThat(ann.control(drone).holder()).isEqualTo("ann");
        }
        // Nobody is there: the rules for drones without anybody bring them home.
        lab.until("all are down", LONGEST, () -> drones.stream().allMatch(LabDrone::isDown));
    }

    @Test
    void aPilotWhoTakesOneHasIt() {
        List<LabDrone> drones = inTheAir(3);
        RecoveryView begun = begins(all("return"));
        lab.untilSeen(
                "they come home",
                Duration.ofSeconds(40),
                () -> view(begun).state().equals("comingDown"));
        drones.get(2).switchedTo(LOITER);
        lab.until(
                "the others are down",
                LONGEST,
                () -> drones.get(0).isDown() && drones.get(1).isDown());
        RecoveryView over = awaitsEnd(begun, new Separation(drones));
        assertThat(leg(over, drones.get(2)).outcome()).isEqualTo("taken");
        assertThat(over.end()).isEqualTo("2 of 3 are down.");
        assertThat(drones.get(2).mode()).isEqualTo(LOITER);
    }

    @Test
    void refusesWithTheNumberWhatDoesNotFitUnderTheCeiling() {
        inTheAir(5);
        RecoveryRequest low = new RecoveryRequest("return", null, 20.0, 33.0, null, null);
        Rejection refused = catchThrowableOfType(Rejection.class, () -> begins(low));
        assertThat(refused.sentence())
                .startsWith("3 of 5 drones fit between 20 m and the ceiling of 33 m above their homes");
        assertThat(refused.code().word()).isEqualTo("recovery-does-not-fit");
    }

    @Test
    void whatAnotherHasIsLeftOutAndNamedUnlessASupervisorTakesItOver() {
        List<LabDrone> drones = inTheAir(3);
        Pilot bob = lab.pilot("bob", Role.OPERATOR);
        Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
        RecoveryRequest taking = new RecoveryRequest("return", null, null, null, true, null);
        ann.takesControl(drones.get(0));
        Rejection none = catchThrowableOfType(
                Rejection.class, () -> lab.server().recoveries().preview(bob.principal(), taking));
        assertThat(none.sentence()).contains("ann has had control of it since");
        assertThat(none.code().word()).isEqualTo("no-drone-to-recover");

        RecoveryPreview of = lab.server().recoveries().preview(chief.principal(), taking);
        assertThat(of.drones()).hasSize(3);
        RecoveryView begun = lab.server().recoveries().begin(chief.principal(), taking);
        assertThat(ann.control(drones.get(0)).holder()).contains("The recovery");
        RecoveryView over = awaitsEnd(begun, new Separation(drones));
        assertThat(over.owner()).isEqualTo("chief");
        assertThat(over.end()).isEqualTo("All are down.");
    }

    @Test
    void anEarlierRecoveryOfTheAskerEndsWhenItsDronesAreTakenOver() {
        List<LabDrone> drones = inTheAir(2);
        RecoveryView first = begins(all("return"));
        Rejection none = catchThrowableOfType(Rejection.class, () -> begins(all("return")));
        assertThat(none.sentence()).contains("Ask with takeOver to take it over.");
        RecoveryView second = begins(new RecoveryRequest("land", null, null, null, true, null));
        lab.untilSeen(
                "the first one is over",
                Duration.ofSeconds(5),
                () -> view(first).state().equals("over"));
        assertThat(view(first).drones()).allMatch(leg -> "taken".equals(leg.outcome()));
        RecoveryView over = awaitsEnd(second, new Separation(drones));
        assertThat(over.end()).isEqualTo("All are down.");
        assertThat(drones).allMatch(drone -> drone.isDown() && drone.mode() != RTL);
    }
}
