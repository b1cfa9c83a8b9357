package org.dronemap.ws.virtual;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.virtual.DroneRequirements;
import org.dronemap.core.virtual.VirtualPlan;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** A virtual drone as its owner writes it. */
@Schema(name = "VirtualDroneRequest", description = "A virtual drone as its owner writes it.")
public record VirtualDroneRequest(
        @Size(min = 1, max = VirtualDroneService.LONGEST_NAME) @Nullable
        String name,

        @Schema(description = "What a drone must be to serve; left out: any that can fly the mission") @Nullable
        NeedsView needs,

        @Schema(description = "Its mission: perhaps a take-off, waypoints, perhaps return or land; left out: none yet")
        @Nullable
        List<MissionItemRequest> items,

        @Schema(
                description = "Up to so many drones share its mission, each flying a part of it, where that is sooner"
                        + " done; left out: one flies it",
                example = "3")
        @Min(1)
        @Max(VirtualPlan.MOST_DRONES)
        @Nullable
        Integer upTo) {

    /** Requirements on a drone that may serve a virtual drone. */
    @Schema(name = "VirtualDroneNeedsView", description = "What a drone must be to serve.")
    public record NeedsView(
            @Schema(description = "null: any") @EnumValues(VehicleKind.class) @Nullable
            String kind,

            @Schema(description = "names of actions") @EnumValues(Capability.class) @Nullable
            List<@Nullable String> capabilities,

            @Schema(description = "minutes in the air with what is in its battery; null: what the mission takes")
            @Min(1)
            @Max(DroneRequirements.LONGEST_ENDURANCE_MINUTES)
            @Nullable
            Integer enduranceMinutes,

            @Schema(description = "where it has to stand; null: anywhere") @Nullable
            AreaView area) {}

    /** A circle. */
    @Schema(name = "VirtualDroneAreaView")
    public record AreaView(
            @Schema(description = "degrees") @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Schema(description = "degrees") @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "metres, 1 to 100000")
            @Min(FieldRanges.LEAST_RADIUS)
            @Max(FieldRanges.MOST_RADIUS)
            @Nullable
            Double radius) {}

    /** Request to start a mission, with the drone's action on loss of the cloud. */
    @Schema(name = "VirtualDroneStartRequest")
    public record StartRequest(
            @Schema(
                    description = "what a drone does by itself when it no longer hears the cloud",
                    allowableValues = {"continue", "rtl"})
            @Nullable
            String onCloudLoss) {}
}
