package org.dronemap.ws.plan;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;

/** The proposed order of one drone's waypoints, with its effort before and after, as clients see it. */
@Schema(name = "TourView")
record TourView(
        @Schema(
                description = "The waypoints' numbers in the request, from 0, in the order in which to fly them; what"
                        + " cannot be visited comes last")
        List<Integer> order,

        @Schema(description = "Flown as they were listed, without those that cannot be visited")
        EffortView before,

        EffortView after,

        @Schema(description = "How much shorter the best order may at most be, as a share; 0: this is the best")
        double gap,

        @Schema(description = "What cannot be visited, and why")
        List<PlanView.UnservedView> unserved) {
    /** Duration (seconds) and distance (metres over the ground) of a tour. */
    @Schema(name = "TourEffortView")
    public record EffortView(
            double seconds,
            @Schema(description = "metres over the ground") double distance) {}
}
