package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.operation.OperationId;
import org.junit.jupiter.api.Test;

/** A run for some drones of the pool whose only drone falls: its waypoints wait for another one, as long as one may come. */
class RunPoolDronesTest {
    private static RunTestBench flownByOne(Integer upTo) {
        PlanningProblem problem = RunFixtures.problem(1, 8, 1, false);
        PlanResult planned = FleetPlanner.plan(problem, 1, SearchBudget.iterations(500), progress -> {});
        RunOrder.Member member = new RunOrder.Member(problem.crafts().get(0).id(), "Drone 0", VehicleKind.MULTICOPTER);
        return new RunTestBench(
                new RunOrder(
                        new OperationId("run-1"),
                        problem,
                        planned.plan(),
                        List.of(member),
                        RunOrder.ApprovalMode.AUTOMATIC,
                        MissionCloudLossPolicy.RETURN_TO_LAUNCH,
                        1,
                        Duration.ofSeconds(2),
                        RunTestBench.START,
                        upTo),
                List.of(new TestVehicle(0, 0, 0)));
    }

    private static RunTestBench fallen(Integer upTo) {
        RunTestBench bench = flownByOne(upTo);
        bench.flyUntil(() -> bench.state.count(RunWaypoint.State.VISITED) >= 2, 600);
        bench.vehicle(0).falling = true;
        bench.flyUntil(() -> bench.drone(0).stage() == RunDroneStage.CRASHED, 5);
        bench.fly(30);
        return bench;
    }

    @Test
    void waitsForOneThatMayJoin() {
        RunTestBench bench = fallen(1);
        assertThat(bench.state.isOver()).isFalse();
        assertThat(bench.state.count(RunWaypoint.State.UNSERVED)).isZero();

        bench.wish(new RunInput.NoPoolDrone(bench.now, "dronemap", "The pool has no other drone for you."));
        bench.fly(5);
        assertThat(bench.state.isOver()).isTrue();
        assertThat(bench.state.count(RunWaypoint.State.UNSERVED)).isEqualTo(6);
    }

    @Test
    void endsWhereNobodyMayJoin() {
        assertThat(fallen(null).state.isOver()).isTrue();
    }
}
