package org.dronemap.ws.service;

import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.plan.MissionWriter;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.core.drone.VehicleKind;

/** Tours as the missions that clients see and commands carry. */
final class PlanMissions {
    private final MissionWriter writer;

    PlanMissions(Craft craft, VehicleKind kind) {
        this.writer = new MissionWriter(craft, kind);
    }

    /** Why no drone can carry it, as a sentence. */
    Optional<String> fault(Tour tour) {
        return writer.fault(tour);
    }

    List<MissionItemView> items(Tour tour) {
        return MissionItemView.of(writer.write(tour).items());
    }
}
