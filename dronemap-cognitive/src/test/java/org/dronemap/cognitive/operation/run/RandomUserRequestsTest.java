package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever people want of a run at whatever moment: what can be visited is, and what cannot is told with its reason. */
class RandomUserRequestsTest {
    private static final double FULL_JOULES = 150_000;

    @ParameterizedTest
    @ValueSource(longs = {3, 5, 14, 96})
    void leaveNothingOutThatCouldBeVisited(long seed) {
        RunTestBench fleet = wished(seed);
        fleet.flyToTheEnd();

        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
        for (RunWaypoint target : fleet.state.targets()) {
            String reason = target.reason();
            boolean explained = target.state() == RunWaypoint.State.VISITED
                    || target.state() == RunWaypoint.State.CANCELLED
                    || (target.id().startsWith("far") && reason != null && reason.startsWith("Out of range"))
                    || (isFenced(fleet, target) && reason != null && reason.contains("keeps drones from"));
            assertThat(explained).as("%s; %s", target, fleet.said).isTrue();
        }
    }

    private static boolean isFenced(RunTestBench fleet, RunWaypoint target) {
        return fleet.state.setting().barriers().stream()
                .map(barrier -> (FenceArea.Circle) barrier.shape())
                .anyMatch(circle -> Geodesy.distanceMeters(
                                circle.center(), target.waypoint().place().point())
                        < circle.radiusMeters() + 2);
    }

    static RunTestBench wished(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        RunTestBench fleet = RunFixtures.fleet(
                RunFixtures.problem(2 + random.nextInt(3), 25, seed, true),
                seed,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.CONTINUE);
        int wishes = 3 + random.nextInt(4);
        for (int i = 0; i < wishes && !fleet.state.isOver(); i++) {
            fleet.fly(random.nextInt(4) == 0 ? random.nextInt(10, 60) : random.nextInt(0, 6));
            if (!fleet.state.isOver()) {
                wish(fleet, random, i);
            }
        }
        return fleet;
    }

    private static void wish(RunTestBench fleet, SplittableRandom random, int number) {
        double east = random.nextDouble(-450, 450);
        double north = random.nextDouble(-450, 450);
        String open = fleet.state.targets().stream()
                .filter(target -> !target.state().isSettled())
                .map(RunWaypoint::id)
                .findFirst()
                .orElse("w0");
        switch (random.nextInt(6)) {
            case 0 -> fence(fleet, east, north, random.nextInt(15, 60), number);
            case 1 -> join(fleet, number);
            case 2 -> add(fleet, "far" + number, 0, 30_000);
            case 3 -> add(fleet, "n" + number, east, north);
            case 4 ->
                fleet.input(
                        new RunInput.MoveWaypoint(fleet.now, "Ann", open, PlanningFixtures.place(east, north, 440)));
            default -> fleet.input(new RunInput.CancelWaypoint(fleet.now, "Ann", open));
        }
    }

    private static void add(RunTestBench fleet, String id, double east, double north) {
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now, "Ann", List.of(Waypoint.at(id, PlanningFixtures.place(east, north, 440)))));
    }

    private static void join(RunTestBench fleet, int number) {
        double east = -40 - 40 * number;
        Craft craft = PlanningFixtures.craft(10 + number, east, 0).with(new EnergyBudget(FULL_JOULES, FULL_JOULES / 5));
        TestVehicle vehicle = new TestVehicle(10 + number, east, 0);
        vehicle.fullJoules = FULL_JOULES;
        vehicle.joules = FULL_JOULES;
        fleet.vehicles.put(craft.id(), vehicle);
        fleet.wish(new RunInput.JoinDrone(fleet.now, "Ann", craft, "Drone " + craft.id(), VehicleKind.MULTICOPTER));
    }

    /** Where nobody stands or flies. */
    private static void fence(RunTestBench fleet, double east, double north, double radius, int number) {
        Optional<TestVehicle> inside = fleet.vehicles.values().stream()
                .filter(vehicle -> Math.hypot(vehicle.east - east, vehicle.north - north) < radius + 60
                        || Math.hypot(vehicle.homeEast - east, vehicle.homeNorth - north) < radius + 60)
                .findFirst();
        if (inside.isEmpty()) {
            fleet.wish(new RunInput.AddBarrier(
                    fleet.now,
                    "Ann",
                    new Barrier(
                            "the no-fly zone “Crane " + number + "”",
                            new FenceArea.Circle(false, PlanningFixtures.point(east, north), radius),
                            AltitudeBand.ALL,
                            Set.of())));
        }
    }
}
