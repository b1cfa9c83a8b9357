package org.dronemap.ws.plan;

import java.util.Locale;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.WaysHome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;

/** Refuses to start a plan in which more drones would be in the air than have a way home apart from each other. */
final class PlanWaysHome {
    private PlanWaysHome() {}

    static void require(PlanJobInput order, Plan plan) {
        WaysHome.of(
                        order.problem(),
                        plan,
                        drone -> order.drones().stream()
                                .filter(state -> state.id().equals(drone))
                                .map(DroneState::identification)
                                .anyMatch(identity -> identity.kind().isRotorcraft()))
                .shortage()
                .ifPresent(shortage -> {
                    throw Rejection.of(
                            OperationProblem.WAYS_HOME_DO_NOT_FIT,
                            sentence(order, shortage),
                            ProblemParameter.DRONES.is(shortage.drones()),
                            ProblemParameter.MOST.is(shortage.fitting()));
                });
    }

    private static String sentence(PlanJobInput order, WaysHome.Shortage shortage) {
        boolean level = shortage.unevenMeters() == shortage.apartMeters();
        return String.format(
                Locale.ROOT,
                "%d of %d drones have a way home between %.0f m (%s) and the ceiling of %.0f m above the home of “%s”:"
                        + " layers are %.0f m apart%s. Take off fewer at once, raise the ceiling, or keep their areas and"
                        + " pads %.0f m apart.",
                shortage.fitting(),
                shortage.drones(),
                shortage.flownMeters(),
                shortage.isFlown() ? "the highest way" : "as high as they return at least",
                shortage.ceilingMeters(),
                order.nameOf(shortage.without()),
                shortage.apartMeters(),
                level
                        ? ""
                        : String.format(
                                Locale.ROOT, ", %.0f m where homes are not known to be level", shortage.unevenMeters()),
                shortage.besideMeters());
    }
}
