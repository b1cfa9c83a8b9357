package org.dronemap.ws.plan;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.cognitive.plan.MissionWriter;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.ws.mission.MissionItemRequest;

/** Turns a drone's tour of a plan into mission items for clients and for upload to the drone. */
final class PlanMissionWriter {
    private final MissionWriter writer;

    /** {@code tasks}: what is done at the waypoint with that id. */
    PlanMissionWriter(Craft craft, VehicleKind kind, Function<String, Task> tasks) {
        this.writer = new MissionWriter(craft, kind, tasks);
    }

    /** Why no drone can carry it, as a sentence. */
    Optional<String> fault(Tour tour) {
        return writer.fault(tour);
    }

    List<MissionItemRequest> items(Tour tour) {
        return MissionItemRequest.of(writer.write(tour).items());
    }
}
