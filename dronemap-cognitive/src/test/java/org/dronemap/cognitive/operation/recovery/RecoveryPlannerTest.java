package org.dronemap.cognitive.operation.recovery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.Separation;
import org.junit.jupiter.api.Test;

/** Plans for drones that come home or down together, judged by flying them at speeds that nobody planned for. */
class RecoveryPlannerTest {
    private static final LocalPlane FIELD = new LocalPlane(new Geodetic(47.4, 8.5));
    private static final double LONGEST = 3_600;
    private static final double TINY = 1e-6;

    private static final RecoveryOrder HOME = RecoveryOrder.of(RecoveryManner.RETURN, 20, 120, Separation.USUAL);
    private static final RecoveryOrder LAND = RecoveryOrder.of(RecoveryManner.LAND, 20, 120, Separation.USUAL);

    private static RecoveryDrone drone(int number, double[] place, double height, double[] home) {
        return drone(number, place, height, home, 500);
    }

    private static RecoveryDrone drone(int number, double[] place, double height, double[] home, double ground) {
        return new RecoveryDrone(
                new DroneId("drone-" + number),
                "Drone " + number,
                FIELD.place(new PlanePoint(place[0], place[1])),
                height,
                new Home(FIELD.place(new PlanePoint(home[0], home[1])), ground),
                120);
    }

    private static double[] at(double east, double north) {
        return new double[] {east, north};
    }

    private static RecoverySlot slot(RecoveryPlan plan, RecoveryDrone drone) {
        return plan.slots().stream()
                .filter(one -> one.drone().equals(drone.drone()))
                .findFirst()
                .orElseThrow();
    }

    private static FlownPlan flown(RecoveryOrder order, List<RecoveryDrone> drones, RecoveryPlan plan, long seed) {
        assertThat(plan.why()).isNull();
        FlownPlan flown = new FlownPlan(order, drones, plan, new Random(seed));
        assertThat(flown.fly(LONGEST)).as("all are down").isTrue();
        return flown;
    }

    /** In a square, nowhere nearer than they have to be. */
    private static List<RecoveryDrone> scattered(Random chance, int count, double metres, boolean rows) {
        List<RecoveryDrone> drones = new ArrayList<>();
        while (drones.size() < count) {
            int number = drones.size();
            double[] home = rows
                    ? at(8 * (number % 5), 8 * (number / 5))
                    : at(metres * chance.nextDouble(), metres * chance.nextDouble());
            double[] place = at(metres * chance.nextDouble(), metres * chance.nextDouble());
            double ground = rows ? 500 : 495 + 10 * chance.nextDouble();
            RecoveryDrone next = drone(number, place, 8 + 80 * chance.nextDouble(), home, ground);
            if (drones.stream().allMatch(other -> areApart(next, other))) {
                drones.add(next);
            }
        }
        return drones;
    }

    private static boolean areApart(RecoveryDrone one, RecoveryDrone other) {
        double beside = FIELD.spot(one.place()).distanceMeters(FIELD.spot(other.place()));
        double pads = FIELD.spot(one.home().point())
                .distanceMeters(FIELD.spot(other.home().point()));
        boolean above =
                Math.abs(one.amslMeters() - other.amslMeters()) >= HOME.apart().verticalMeters() + 10;
        return pads > 5 && (beside >= HOME.apart().horizontalMeters() || (above && beside > 5));
    }

    @Test
    void noTwoComeNearEachOtherOnAnyWayHomeHoweverFastTheyFly() {
        int planned = 0;
        for (int seed = 0; seed < 300; seed++) {
            Random chance = new Random(seed);
            boolean rows = chance.nextBoolean();
            List<RecoveryDrone> drones = scattered(chance, 2 + chance.nextInt(8), 250, rows);
            RecoveryPlan plan = RecoveryPlanner.plan(HOME, drones);
            if (plan.why() != null) {
                assertThat(plan.why()).contains("fit between");
                continue;
            }
            planned++;
            FlownPlan flown = flown(HOME, drones, plan, seed);
            assertThat(flown.least()).as("seed %d: %s", seed, flown.where()).isGreaterThan(1 - TINY);
        }
        assertThat(planned).isGreaterThan(200);
    }

    @Test
    void noTwoComeNearEachOtherWhenEachLandsWhereItIs() {
        for (int seed = 0; seed < 200; seed++) {
            Random chance = new Random(seed);
            List<RecoveryDrone> drones = scattered(chance, 2 + chance.nextInt(10), 60, false);
            RecoveryPlan plan = RecoveryPlanner.plan(LAND, drones);
            FlownPlan flown = flown(LAND, drones, plan, seed);
            assertThat(flown.least()).as("seed %d: %s", seed, flown.where()).isGreaterThan(1 - TINY);
        }
    }

    @Test
    void eightThatStandOverEachOthersHomesAllComeDown() {
        List<RecoveryDrone> drones = IntStream.range(0, 8)
                .mapToObj(i -> drone(i, at(30 * (7 - i), 0), 25, at(30 * i, 0)))
                .toList();
        RecoveryPlan plan = RecoveryPlanner.plan(HOME, drones);
        assertThat(flown(HOME, drones, plan, 1).least()).isGreaterThan(1 - TINY);
        assertThat(plan.slots()).allMatch(slot -> slot.layerMeters() >= 20 && slot.layerMeters() <= 120);
    }

    @Test
    void whoStandsHigherFliesHomeHigherAndStaysWhereItCan() {
        RecoveryDrone low = drone(0, at(0, 100), 30, at(0, 0));
        RecoveryDrone high = drone(1, at(10, 100), 60, at(6, 0));
        RecoveryPlan plan = RecoveryPlanner.plan(HOME, List.of(high, low));
        assertThat(slot(plan, low).layerMeters()).isEqualTo(30);
        assertThat(slot(plan, high).layerMeters()).isEqualTo(60);
        // Its home is beside that of the other one, which comes down first.
        assertThat(slot(plan, high).waits())
                .contains(new RecoveryWait(RecoveryStep.DESCENDING, low.drone(), RecoveryStep.DOWN));
        assertThat(slot(plan, low).waits()).isEmpty();
    }

    @Test
    void whoFliesHomeFarFromAllOthersWaitsForNobody() {
        List<RecoveryDrone> drones =
                List.of(drone(0, at(0, 100), 30, at(0, 0)), drone(1, at(200, 100), 30, at(200, 0)));
        RecoveryPlan plan = RecoveryPlanner.plan(HOME, drones);
        assertThat(plan.slots()).allMatch(slot -> slot.waits().isEmpty() && slot.layerMeters() == 30);
    }

    @Test
    void refusesMoreDronesThanTheCeilingLetsFlyHomeAboveEachOther() {
        List<RecoveryDrone> drones = IntStream.range(0, 9)
                .mapToObj(i -> drone(i, at(20 * (8 - i), 300), 30, at(5 * i, 0)))
                .toList();
        RecoveryOrder low = RecoveryOrder.of(RecoveryManner.RETURN, 20, 45, Separation.USUAL);
        List<RecoveryDrone> bounded = drones.stream()
                .map(one -> new RecoveryDrone(one.drone(), one.name(), one.place(), one.heightMeters(), one.home(), 45))
                .toList();
        RecoveryPlan plan = RecoveryPlanner.plan(low, bounded);
        assertThat(plan.why()).startsWith("5 of 9 drones fit between 20 m and the ceiling of 45 m above their homes");
        assertThat(plan.fitting()).isEqualTo(5);
        assertThat(plan.slots()).isEmpty();
    }

    @Test
    void refusesByNameTwoThatWouldComeDownOnOneSpot() {
        RecoveryDrone one = drone(0, at(0, 100), 30, at(0, 0));
        RecoveryDrone other = drone(1, at(50, 100), 60, at(2, 0));
        assertThat(RecoveryPlanner.plan(HOME, List.of(one, other)).why())
                .isEqualTo("Drone 0 and Drone 1 would come down 2.0 m from each other; at least 4 m are kept."
                        + " Set another home for one of them, or leave it out.");
        assertThat(RecoveryPlanner.plan(LAND, List.of(one, other)).why()).isNull();
    }

    @Test
    void theLowerOfTwoThatLandBesideEachOtherLandsFirst() {
        RecoveryDrone high = drone(0, at(0, 0), 60, at(0, 0));
        RecoveryDrone low = drone(1, at(8, 0), 20, at(100, 0));
        RecoveryPlan plan = RecoveryPlanner.plan(LAND, List.of(high, low));
        assertThat(plan.slots()).extracting(RecoverySlot::drone).containsExactly(low.drone(), high.drone());
        assertThat(slot(plan, high).waits())
                .contains(new RecoveryWait(RecoveryStep.DESCENDING, low.drone(), RecoveryStep.DOWN));
        assertThat(slot(plan, low).comesDown()).isEqualTo(low.place());
    }
}
