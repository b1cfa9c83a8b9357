package org.dronemap.ws.run;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.zone.ZoneFeature;
import org.jspecify.annotations.Nullable;

/** A mission run as clients see it. */
@Schema(name = "RunView", description = "A plan that drones fly, as it stands.")
public record RunView(
        String id,
        String name,

        @Schema(description = "The user whom it is flown for")
        String owner,

        Instant beganAt,

        @Schema(description = "null: it is under way") @Nullable
        Instant endedAt,

        @Schema(allowableValues = {"running", "paused", "stopping", "over"})
        String state,

        @Schema(description = "How it ended") @Nullable String end,

        @EnumValues(RunOrder.ApprovalMode.class) String mode,

        @Schema(allowableValues = {"continue", "rtl"}) String onCloudLoss,

        @Schema(description = "Up to so many drones of the pool fly it, chosen by the cloud; null: they were named")
        @Nullable
        Integer upTo,

        CountsView counts,
        List<DroneView> drones,
        List<WaypointView> waypoints,

        @Schema(
                description =
                        "What its drones keep to as far as the run knows: the cloud's zones in reach, and what was added to"
                                + " the run alone. GeoJSON features like zones; without an id")
        List<ZoneFeature> barriers,

        @Schema(description = "A changed plan that waits for an answer; null: none does") @Nullable
        ProposalView proposal,

        @Schema(description = "The newest 50, the oldest first")
        List<ExplanationView> explanations,

        @Schema(description = "The number of the newest entry of its journal")
        long journal) {
    /** Progress of a run: counts of its waypoints by state, of replans and of double visits. */
    @Schema(name = "RunCountsView")
    public record CountsView(
            int waypoints,
            long visited,
            long unserved,
            long cancelled,

            @Schema(description = "How often a plan was made anew")
            int replans,

            @Schema(
                    description =
                            "Visits of waypoints that had been visited already, by drones that were out of contact")
            int doubles) {}

    /** One drone of it. */
    @Schema(name = "RunDroneView")
    public record DroneView(
            String id,
            String name,

            @EnumValues(RunDroneStage.class) String stage,

            Instant since,

            @Schema(description = "Why it is not flying its waypoints") @Nullable
            String note,

            @Schema(description = "The waypoints that it is to visit, in order")
            List<String> next,

            int visited,

            @Schema(description = "When it is to be at its end by the plan that it flies") @Nullable
            Instant due) {}

    /** One waypoint of it. */
    @Schema(name = "RunWaypointView")
    public record WaypointView(
            String id,
            double latitude,
            double longitude,

            @Schema(description = "metres above mean sea level")
            double altitudeAmsl,

            @EnumValues(RunWaypoint.State.class) String state,

            @Schema(description = "Whose it is") @Nullable String drone,

            @Schema(description = "Why nobody visits it") @Nullable
            String why,

            @Schema(description = "When it is to be visited") @Nullable
            Instant due,

            List<VisitView> visits,

            @Schema(description = "What is done there, and what became of it")
            List<TaskView> tasks) {}

    /** One task of a waypoint. */
    @Schema(name = "RunTaskView")
    public record TaskView(
            @Schema(allowableValues = {"photo", "servo", "lookAt", "readSensors"})
            String type,

            @Schema(
                    description = "notKnown: a drone was told to and nothing shows what came of it;"
                            + " notAvailable: nothing of the kind is told by it")
            @EnumValues(value = RunWaypoint.Report.Result.class, and = "open")
            String result,

            @Schema(description = "Who did it, or was told to") @Nullable
            String drone,

            @Schema(description = "When that was learned") @Nullable
            Instant at,

            @Schema(description = "The number of the photo, by the drone's own count") @Nullable
            Integer photo,

            @Schema(description = "What came of it, as a sentence") @Nullable
            String words) {}

    /** Visit of a drone to a waypoint, with the time at which the cloud learned of it. */
    @Schema(name = "RunVisitView")
    public record VisitView(String drone, Instant at) {}

    /** A changed plan. */
    @Schema(name = "RunProposalView")
    public record ProposalView(
            int number, Instant at, String words, List<MovedView> moved, FiguresView before, FiguresView after) {}

    /** A waypoint that is another drone's now. */
    @Schema(name = "RunMovedView")
    public record MovedView(
            String waypoint,
            @Nullable String from,
            @Nullable String to) {}

    /** Key figures of a plan: longest duration, cost and number of unserved waypoints. */
    @Schema(name = "RunFiguresView")
    public record FiguresView(
            @Schema(description = "When the last drone is at its end")
            double longestSeconds,

            double cost,
            int unserved) {}

    /** One decision. */
    @Schema(name = "RunExplanationView")
    public record ExplanationView(
            int number,
            Instant at,

            @Schema(description = "What it was decided for") @EnumValues(RunTrigger.class)
            String trigger,

            @Nullable String drone,
            List<MovedView> moved,
            @Nullable FiguresView before,
            @Nullable FiguresView after,
            String words) {}
}
