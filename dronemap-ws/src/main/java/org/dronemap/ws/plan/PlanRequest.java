package org.dronemap.ws.plan;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.DecimalMin;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.mission.Altitude;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** A request to plan missions for several drones, as a client writes it. Nothing is checked yet. */
@Schema(name = "PlanRequest", description = "Waypoints that are to be shared out among drones.")
public record PlanRequest(
        @Schema(description = "1 to 5000", requiredMode = Schema.RequiredMode.REQUIRED)
        @Size(min = 1, max = PlanWaypointReader.MOST)
        @Nullable
        List<@Nullable WaypointRequest> waypoints,

        @Schema(description = "Ids of 1 to 100 drones that are on the ground; left out with upTo")
        @Size(min = 1, max = PlanReader.MOST_DRONES)
        @Nullable
        List<@Nullable String> drones,

        @Schema(
                description =
                        "1 to 100: the cloud chooses up to so many drones of the pool that you may command, those that"
                                + " are free and nearest to the waypoints; left out with drones")
        @Min(1)
        @Max(PlanReader.MOST_DRONES)
        @Nullable
        Integer upTo,

        @Schema(description = "What the plan is to be good at; left out: all done as early as can be") @Nullable
        PlanObjectiveRequest objective,

        @Schema(description = "Seconds to search, 0.1 to 60; left out: 5")
        @DecimalMin("" + PlanReader.LEAST_SECONDS)
        @Max(PlanReader.MOST_SECONDS)
        @Nullable
        Double seconds,

        @Schema(description = "Where the search begins; left out: 1") @Nullable
        Long seed,

        @Schema(description = "The same everywhere; left out: calm") @Nullable
        WindRequest wind) {
    /** A place that one drone is to visit. */
    @Schema(name = "PlanWaypointRequest", description = "A place that one drone is to visit.")
    public record WaypointRequest(
            @Schema(description = "Your own name of it, up to 40 characters; left out: its number from 1")
            @Size(min = 1, max = PlanWaypointReader.LONGEST_ID)
            @Nullable
            String id,

            @Schema(description = "degrees") @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Schema(description = "degrees") @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "metres")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude,

            @Schema(
                    description =
                            "home (the default): above the highest home of these drones, which must lie within 20 m;"
                                    + " or amsl")
            @EnumValues(Altitude.Reference.class)
            @Nullable
            String altitudeReference,

            @Schema(description = "Seconds that the drone stays there, 0 to 3600; left out: 0")
            @Min(0)
            @Max(FieldRanges.MOST_SECONDS)
            @Nullable
            Double holdSeconds,

            @Schema(description = "What leaving it out weighs beside others, 0.001 to 1000; left out: 1")
            @DecimalMin("" + Waypoint.LEAST_PRIORITY)
            @Max((int) Waypoint.HIGHEST_PRIORITY)
            @Nullable
            Double priority,

            @Schema(description = "When its task may begin; left out: at any time") @Nullable
            WindowRequest window,

            @Schema(description = "What a drone must be able to do for it, such as takePicture") @Nullable
            List<@Nullable String> needs,

            @Schema(description = "What is done there, in order; up to 10") @Size(max = PlanTaskRequest.MOST) @Nullable
            List<@Nullable PlanTaskRequest> tasks) {
        public WaypointRequest called(String name) {
            return new WaypointRequest(
                    name,
                    latitude,
                    longitude,
                    altitude,
                    altitudeReference,
                    holdSeconds,
                    priority,
                    window,
                    needs,
                    tasks);
        }
    }

    /** A span on the plan's clock. */
    @Schema(name = "PlanWindowRequest", description = "Seconds after the start of the plan.")
    public record WindowRequest(
            @Schema(description = "left out: 0") @Min(0) @Max(PlanWaypointReader.LONGEST_WINDOW_SECONDS) @Nullable
            Double opens,

            @Schema(description = "left out: never") @Min(0) @Max(PlanWaypointReader.LONGEST_WINDOW_SECONDS) @Nullable
            Double closes) {}

    /** Wind that is the same everywhere. */
    @Schema(name = "PlanWindRequest")
    public record WindRequest(
            @Schema(description = "m/s, 0 to 100") @Min(0) @Max(PlanReader.STRONGEST_WIND) @Nullable
            Double speed,

            @Schema(description = "where it comes from: degrees clockwise from north, 0 to 360")
            @Min(0)
            @Max(PlanReader.FULL_CIRCLE)
            @Nullable
            Double from) {}

    /** Request to accept a plan, with its start options. */
    @Schema(name = "PlanAcceptRequest", description = "How a plan is accepted.")
    public record AcceptRequest(
            @Schema(
                    description =
                            "Whether the drones are armed and started, each when the plan says, once all have their"
                                    + " missions; left out: no")
            @Nullable
            Boolean start,

            @Schema(
                    description = "what a drone does by itself when it no longer hears the cloud",
                    allowableValues = {"continue", "rtl"})
            @Nullable
            String onCloudLoss) {}
}
