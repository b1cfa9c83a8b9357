package org.dronemap.ws.run;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.core.mission.Altitude;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/**
 * Requests about mission runs (start, add or move waypoints, add drones, answer proposals) as a client writes them.
 * Nothing is checked yet.
 */
public final class RunRequest {
    private RunRequest() {}

    /** A plan that is to be flown. */
    @Schema(name = "RunStartRequest", description = "A finished plan of yours that is to be flown, and how.")
    public record StartRequest(
            @Schema(description = "The id of the plan", requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            String plan,

            @Schema(
                    description =
                            "automatic (the default): a changed plan is flown at once; askFirst: it waits for an answer,"
                                    + " but for what is unsafe for a drone")
            @EnumValues(RunOrder.ApprovalMode.class)
            @Nullable
            String mode,

            @Schema(
                    description = "What drones do when they no longer hear the cloud; left out: continue",
                    allowableValues = {"continue", "rtl"})
            @Nullable
            String onCloudLoss,

            @Schema(description = "For people, up to 60 characters; left out: Mission run")
            @Size(min = 1, max = RunReader.LONGEST_NAME)
            @Nullable
            String name,

            @Schema(description = "Seconds to look for a better plan when something changes, 0 to 60; left out: 2")
            @Min(0)
            @Max(RunReader.MOST_SEARCH_SECONDS)
            @Nullable
            Double searchSeconds) {}

    /** Further places. */
    @Schema(
            name = "RunWaypointsRequest",
            description = "Further waypoints; windows count from the beginning of the run.")
    public record WaypointsRequest(
            @Schema(description = "1 to 500", requiredMode = Schema.RequiredMode.REQUIRED)
            @Size(min = 1, max = RunReader.MOST_AT_ONCE)
            @Nullable
            List<PlanRequest.@Nullable WaypointRequest> waypoints) {}

    /** Request to move a waypoint. */
    @Schema(name = "RunMoveRequest", description = "Where a waypoint is from now on; what is left out stays.")
    public record MoveRequest(
            @Schema(description = "degrees") @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Schema(description = "degrees") @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "metres")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude,

            @Schema(description = "home (the default): above the highest home of the run's drones; or amsl")
            @EnumValues(Altitude.Reference.class)
            @Nullable
            String altitudeReference) {}

    /** A drone that joins. */
    @Schema(name = "RunJoinRequest", description = "A further drone, on the ground and free.")
    public record JoinRequest(
            @Schema(description = "The id of the drone", requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            String drone) {}

    /** Request to accept or reject a proposal. */
    @Schema(name = "RunAnswerRequest", description = "Whether what was proposed is to be flown.")
    public record AnswerRequest(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            Boolean accept) {}
}
