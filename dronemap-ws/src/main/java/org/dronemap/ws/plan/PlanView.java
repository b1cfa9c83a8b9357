package org.dronemap.ws.plan;

import com.fasterxml.jackson.annotation.JsonIgnore;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** A plan for several drones, with search progress, result and launch of its flights, as clients see it. */
@Schema(name = "PlanView", description = "A plan, from being asked for to being flown.")
public record PlanView(
        String id,
        String by,
        Instant askedAt,

        @EnumValues(PlanJob.State.class) String state,

        @Schema(description = "failed: why") @Nullable String why,
        @Schema(description = "Seconds to search") double seconds,
        long seed,
        List<DroneName> drones,

        @Schema(description = "The cloud chose up to so many drones of the pool; null: they were named") @Nullable
        Integer upTo,

        @Schema(description = "How many waypoints there are to visit")
        int waypoints,

        @Schema(description = "Of the best plan so far; null before the first one") @Nullable
        ProgressView progress,

        @Schema(description = "Each better plan; of many only some. Left out of lists") @Nullable
        List<ProgressView> improvements,

        @Schema(description = "Who visits what in which order in the best plan so far. Left out of lists") @Nullable
        List<OrderView> orders,

        @Schema(description = "finished: who flies where and when. Left out of lists") @Nullable
        ResultView result,

        @Schema(description = "Once accepted: one outcome for each drone") @Nullable
        LaunchView launch) {
    /** A drone and what it is called; its own id where it is gone. */
    @Schema(name = "PlanDroneName")
    public record DroneName(String id, String name) {}

    /** Quality of a plan: duration, cost, waypoints left out and gap to the optimum. */
    @Schema(name = "PlanProgressView")
    public record ProgressView(
            @Schema(description = "Seconds since the search began")
            double seconds,

            @Schema(description = "Seconds until the last drone is at its end")
            double longestSeconds,

            @Schema(description = "What the objective sums, in its unit")
            double sum,

            int unserved,

            @Schema(
                    description =
                            "How far it may at most be from the best plan, as a share of its own cost: 0 is proved"
                                    + " best; 1 while waypoints are left out")
            double gap,

            @Schema(description = "How many changes were tried")
            long iterations) {}

    /** The waypoints of one drone, in order. */
    @Schema(name = "PlanOrderView")
    public record OrderView(String drone, List<String> waypoints) {}

    /** Result of planning: the drones' tours, unserved waypoints and faults. */
    @Schema(name = "PlanResultView")
    public record ResultView(
            double endsSeconds,
            List<TourView> tours,
            List<UnservedView> unserved,

            @Schema(description = "Why it must not be flown, as sentences of an independent checker; none: it can be")
            List<String> faults,

            @Schema(description = "Whether speeds, power and batteries are those of the kind of vehicle, not measured")
            boolean assumed) {}

    /** Tour of one drone; seconds count from the start of the plan. */
    @Schema(name = "PlanTourView")
    public record TourView(
            String drone,
            String name,
            double departsSeconds,
            double endsSeconds,
            @Schema(description = "metres over the ground") double distance,
            double wattHours,

            @Schema(description = "Share of what it may draw, 0 to 1; null: no limit is known") @Nullable
            Double batteryShare,

            List<StopView> stops,

            @Schema(description = "From the last stop to the end: the end is the last place")
            List<PlaceView> back) {}

    /** A visit. */
    @Schema(name = "PlanStopView")
    public record StopView(
            String waypoint,
            double latitude,
            double longitude,
            double altitudeAmsl,
            double arrivesSeconds,
            double beginsSeconds,
            double leavesSeconds,

            @Schema(description = "Drawn since the start, when it leaves")
            double wattHours,

            @Schema(description = "Passed on the way there, such as turns round zones")
            List<PlaceView> via) {}

    /** A place in the air; altitude in metres above mean sea level. */
    @Schema(name = "PlanPlaceView")
    public record PlaceView(double latitude, double longitude, double altitudeAmsl) {}

    /** Waypoint that no drone visits, with the reason. */
    @Schema(name = "PlanUnservedView")
    public record UnservedView(String waypoint, String why, PlaceView place) {}

    /** Progress of a plan's launch after its acceptance, drone by drone. */
    @Schema(name = "PlanLaunchView")
    public record LaunchView(
            @Schema(description = "Whether something is still under way")
            boolean underWay,

            List<DroneLaunchView> drones) {}

    /** One drone's outcome. */
    @Schema(name = "PlanFlightView")
    public record DroneLaunchView(
            String drone,
            String name,

            @EnumValues(DroneLaunchStatus.Stage.class) String stage,

            @Nullable String why,

            @Schema(description = "The same for programs; docs/problems.md lists them") @Nullable
            String code,

            @Schema(description = "The last command that was given for it") @Nullable
            String command) {}

    /** Nothing of it is under way any more. */
    @JsonIgnore
    public boolean isLaunched() {
        return launch != null && !launch.underWay();
    }
}
