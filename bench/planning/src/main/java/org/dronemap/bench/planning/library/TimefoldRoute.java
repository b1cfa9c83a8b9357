package org.dronemap.bench.planning.library;

import ai.timefold.solver.core.api.domain.entity.PlanningEntity;
import ai.timefold.solver.core.api.domain.variable.PlanningListVariable;
import java.util.ArrayList;
import java.util.List;

/** One drone's tour as Timefold changes it. */
@PlanningEntity
public class TimefoldRoute {
    private int drone;

    @PlanningListVariable
    private List<TimefoldStop> stops = new ArrayList<>();

    TimefoldRoute() {}

    TimefoldRoute(int drone) {
        this.drone = drone;
    }

    int drone() {
        return drone;
    }

    List<TimefoldStop> stops() {
        return stops;
    }
}
