package org.dronemap.ws.virtual;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.virtual.VirtualRunStage;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.mission.MissionItemView;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.run.RunView;
import org.jspecify.annotations.Nullable;

/** A virtual drone as clients see it; only those who may see the real drone that serves it learn which it is. */
@Schema(name = "VirtualDroneView", description = "A virtual drone: drone-shaped, with an id and a name of its own.")
public record VirtualDroneView(
        String id,
        String name,
        String owner,
        VirtualDroneRequest.NeedsView needs,

        @Schema(description = "The mission as planned; null: none yet") @Nullable
        List<MissionItemView> items,

        @Schema(description = "Up to so many drones share its mission, each flying a part of it; null: one flies it")
        @Nullable
        Integer upTo,

        @Schema(description = "Its mission as it was last asked for; null: never") @Nullable
        RunView run,

        @Schema(description = "The drone that serves it (of several the first), without its name; null: none does")
        @Nullable
        LiveView live,

        @Schema(description = "For each action whether the asker can have it now, and if not, why")
        Map<String, DroneView.ActionView> actions) {

    /** A mission from being asked for to its end. */
    @Schema(name = "VirtualDroneRunView", description = "A mission from being asked for to its end.")
    public record RunView(
            @EnumValues(VirtualRunStage.class) String state,

            @Schema(description = "How it is, for people") String sentence,

            @Schema(description = "Place in the queue, counted from 1; null: it does not wait") @Nullable
            PlaceView queue,

            @Schema(description = "Waypoints that are flown")
            int flown,

            @Schema(description = "Waypoints in all") int total,
            @Schema(allowableValues = {"continue", "rtl"}) String onCloudLoss,

            @Schema(description = "Drones that serve it now; null: none") @Nullable
            Integer drones,

            @Schema(description = "Why this drone was chosen; null: none is bound, or there are several shares")
            @Nullable
            String why,

            @Schema(
                    description = "The drone that serves it; null: none, the asker may not see it, or there are several"
                            + " shares")
            @Nullable
            DroneName drone,

            @Schema(
                    description = "What drone or gate said; null: nothing, the asker may not see it, or there are"
                            + " several shares")
            @Nullable
            String detail,

            @Schema(
                    description =
                            "The parts of the mission in their order, each flown by one drone; one, unless several"
                                    + " drones share it")
            List<ShareView> shares,

            @Schema(description = "Drones that cannot serve now, and why; only those that the asker may see")
            List<UnfitView> unfit,

            Instant changedAt) {}

    /** A part of a mission that one drone flies at a time. */
    @Schema(name = "VirtualDroneShareView", description = "A part of a mission that one drone flies at a time.")
    public record ShareView(
            @EnumValues(VirtualRunStage.class) String state,

            @Schema(description = "How it is, for people") String sentence,

            @Schema(description = "Waypoints of it that are flown")
            int flown,

            @Schema(description = "Waypoints in it") int total,

            @Schema(description = "Why this drone was chosen; null: none is bound") @Nullable
            String why,

            @Schema(description = "The drone that serves it; null: none, or the asker may not see it") @Nullable
            DroneName drone,

            @Schema(description = "What drone or gate said; null: nothing, or the asker may not see it") @Nullable
            String detail,

            @Schema(description = "The drone that serves it, without its name; null: none does") @Nullable
            LiveView live) {}

    /** Counted from 1. */
    @Schema(name = "VirtualDronePlaceView")
    public record PlaceView(int position, int length) {}

    /** A drone that the asker may see. */
    @Schema(name = "VirtualDroneDroneName")
    public record DroneName(String id, String name) {}

    /** A drone that cannot serve now. */
    @Schema(name = "VirtualDroneUnfitView")
    public record UnfitView(
            DroneName drone,
            String why,

            @Schema(description = "The same for programs; docs/problems.md lists them")
            String code) {}

    /** Live state of the drone that serves the virtual drone. */
    @Schema(name = "VirtualDroneLiveView")
    public record LiveView(
            @EnumValues(LinkState.class) String link,
            @EnumValues(VehicleKind.class) String kind,
            @Nullable Boolean armed,
            @EnumValues(FlightPhase.class) @Nullable String flight,
            DroneView.@Nullable PositionView position,
            DroneView.@Nullable MotionView motion,
            @Schema(description = "per cent") @Nullable Integer battery) {}
}
