package org.dronemap.ws.service;

import com.fasterxml.jackson.annotation.JsonInclude;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** One step of a mission as clients read and write it; which members are there depends on the type. */
@JsonInclude(JsonInclude.Include.NON_NULL)
@Schema(description = "One step of a mission; which members are there depends on the type.")
public record MissionItemView(
        @Schema(description = "takeOff, waypoint, returnToLaunch, land; read only: other") @Nullable
        String type,

        @Schema(description = "waypoint: degrees") @Nullable Double latitude,
        @Schema(description = "waypoint: degrees") @Nullable Double longitude,

        @Schema(description = "takeOff, waypoint: metres") @Nullable
        Double altitude,

        @Schema(description = "waypoint: home (the default) or amsl") @Nullable
        String altitudeReference,

        @Schema(description = "waypoint: seconds to wait there") @Nullable
        Double holdSeconds,

        @Schema(description = "other: what it is") @Nullable String description) {

    public static MissionItemView of(MissionItem item) {
        if (item instanceof MissionItem.TakeOff takeOff) {
            return new MissionItemView("takeOff", null, null, takeOff.altitudeMeters(), null, null, null);
        }
        if (item instanceof MissionItem.Waypoint waypoint) {
            return new MissionItemView(
                    "waypoint",
                    waypoint.point().latitudeDegrees(),
                    waypoint.point().longitudeDegrees(),
                    waypoint.altitude().meters(),
                    WireNames.camel(waypoint.altitude().reference()),
                    waypoint.holdSeconds(),
                    null);
        }
        String description = item instanceof MissionItem.Other other ? other.description() : null;
        return new MissionItemView(
                WireNames.lowerFirst(item.getClass().getSimpleName()), null, null, null, null, null, description);
    }

    public static List<MissionItemView> of(List<MissionItem> items) {
        return items.stream().map(MissionItemView::of).toList();
    }
}
