package org.dronemap.ws.plan;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.DecimalMin;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.mission.Mission;
import org.jspecify.annotations.Nullable;

/** A request to order the waypoints of one drone's mission, as a client writes it. Nothing is checked yet. */
@Schema(name = "TourRequest", description = "Waypoints of one drone that are to be put into a good order.")
record TourRequest(
        @Schema(description = "The id of the drone", requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
        String drone,

        @Schema(description = "1 to 500", requiredMode = Schema.RequiredMode.REQUIRED)
        @Size(min = 1, max = Mission.MAX_ITEMS)
        @Nullable
        List<PlanRequest.@Nullable WaypointRequest> waypoints,

        @Schema(
                description = "hold or land: the last waypoint stays the last, since the drone ends there;"
                        + " returnToLaunch (left out): it ends at its home",
                allowableValues = {"hold", "land", "returnToLaunch"})
        @Nullable
        String ending,

        @Schema(description = "Seconds to search, 0.1 to 5; left out: 1")
        @DecimalMin("" + TourReader.LEAST_SECONDS)
        @Max(TourReader.MOST_SECONDS)
        @Nullable
        Double seconds) {}
