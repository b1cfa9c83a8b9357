package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.operation.OperationId;

/** Runs with drones side by side and waypoints all around. */
final class RunFixtures {
    private static final double FULL_JOULES = 150_000;
    private static final double RESERVE = 0.2;

    private RunFixtures() {}

    static RunTestBench fleet(int drones, int waypoints, long seed) {
        return fleet(drones, waypoints, seed, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
    }

    static RunTestBench fleet(int drones, int waypoints, long seed, MissionCloudLossPolicy loss) {
        return fleet(problem(drones, waypoints, seed, false), seed, RunOrder.ApprovalMode.AUTOMATIC, loss);
    }

    /** With batteries. */
    static RunTestBench limited(int drones, int waypoints, long seed) {
        return fleet(
                problem(drones, waypoints, seed, true),
                seed,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.RETURN_TO_LAUNCH);
    }

    static PlanningProblem problem(int drones, int waypoints, long seed, boolean limited) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            double north = random.nextDouble(-500, 500);
            double east = random.nextDouble(-500, 500);
            places.add(Waypoint.at("w" + i, PlanningFixtures.place(east, north, 430 + 5 * random.nextInt(4))));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int i = 0; i < drones; i++) {
            Craft craft = PlanningFixtures.craft(i, 40.0 * i, 0);
            crafts.add(limited ? craft.with(new EnergyBudget(FULL_JOULES, RESERVE * FULL_JOULES)) : craft);
        }
        return PlanningProblem.of(places, crafts);
    }

    /** The same with drones of these kinds, where those that drive have no heights to keep. */
    static RunTestBench mixed(long seed, int waypoints, VehicleKind... kinds) {
        PlanningProblem copters = problem(kinds.length, waypoints, seed, false);
        List<Craft> crafts = new ArrayList<>();
        for (int i = 0; i < kinds.length; i++) {
            Craft craft = copters.crafts().get(i);
            crafts.add(kinds[i] == VehicleKind.MULTICOPTER ? craft : craft.with(performance(kinds[i])));
        }
        return fleet(
                PlanningProblem.of(copters.waypoints(), crafts),
                seed,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.RETURN_TO_LAUNCH,
                kinds);
    }

    /** As quick as the vehicles of the tests are. */
    private static Performance performance(VehicleKind kind) {
        Performance usual = Performance.of(kind);
        return new Performance(
                new Speeds(10, 2, 1, 0.5, 15, Double.POSITIVE_INFINITY), usual.power(), usual.response(), true);
    }

    static RunTestBench fleet(
            PlanningProblem problem,
            long seed,
            RunOrder.ApprovalMode mode,
            MissionCloudLossPolicy loss,
            VehicleKind... kinds) {
        PlanResult planned = FleetPlanner.plan(problem, seed, SearchBudget.iterations(2_000), progress -> {});
        if (!planned.canBeFlown()) {
            throw new IllegalStateException("seed " + seed + ": " + planned.faults());
        }
        List<RunOrder.Member> members = new ArrayList<>();
        List<TestVehicle> vehicles = new ArrayList<>();
        for (int i = 0; i < problem.crafts().size(); i++) {
            Craft craft = problem.crafts().get(i);
            VehicleKind kind = kinds.length == 0 ? VehicleKind.MULTICOPTER : kinds[i];
            members.add(new RunOrder.Member(craft.id(), "Drone " + craft.id(), kind));
            TestVehicle vehicle = new TestVehicle(i, 40.0 * i, 0);
            vehicle.kind = kind;
            if (Double.isFinite(craft.supply().remainingJoules())) {
                vehicle.fullJoules = craft.supply().remainingJoules();
                vehicle.joules = vehicle.fullJoules;
            }
            vehicles.add(vehicle);
        }
        RunOrder order = new RunOrder(
                new OperationId("run-" + seed),
                problem,
                planned.plan(),
                members,
                mode,
                loss,
                seed,
                Duration.ofSeconds(2),
                RunTestBench.START);
        return new RunTestBench(order, vehicles);
    }

    /** North and south, by Ann. */
    static void addTwoWaypoints(RunTestBench fleet) {
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now,
                "Ann",
                List.of(
                        Waypoint.at("n1", PlanningFixtures.place(100, 300, 440)),
                        Waypoint.at("n2", PlanningFixtures.place(-100, -300, 440)))));
    }
}
