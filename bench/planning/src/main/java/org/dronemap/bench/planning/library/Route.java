package org.dronemap.bench.planning.library;

import ai.timefold.solver.core.api.domain.entity.PlanningEntity;
import ai.timefold.solver.core.api.domain.variable.PlanningListVariable;
import java.util.ArrayList;
import java.util.List;

/** One drone's tour as Timefold changes it. */
@PlanningEntity
public class Route {
    private int drone;

    @PlanningListVariable
    private List<Stop> stops = new ArrayList<>();

    Route() {}

    Route(int drone) {
        this.drone = drone;
    }

    int drone() {
        return drone;
    }

    List<Stop> stops() {
        return stops;
    }
}
