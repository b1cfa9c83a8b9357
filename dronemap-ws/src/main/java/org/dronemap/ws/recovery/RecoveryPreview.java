package org.dronemap.ws.recovery;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryManner;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** A preview of a recovery (its drones, heights, order and spots if it began now), as clients see it before they confirm it. */
@Schema(name = "RecoveryPreview", description = "What would be done if it began now.")
public record RecoveryPreview(
        @EnumValues(RecoveryManner.class) String manner,

        @Schema(description = "metres above each drone's home: none flies home below")
        double lowest,

        @Schema(description = "metres above each drone's home: none flies home above")
        double ceiling,

        @Schema(description = "seconds until all are down, as far as can be said")
        double seconds,

        @Schema(description = "In the order in which they come down")
        List<PlannedView> drones,

        @Schema(description = "Drones that it leaves alone") List<LeftOutView> leftOut) {
    /** One drone of a preview. */
    @Schema(name = "RecoveryPlannedView", description = "One drone that comes.")
    public record PlannedView(
            String drone,

            String droneName,

            @Schema(description = "degrees: where it is") double fromLatitude,

            @Schema(description = "degrees") double fromLongitude,

            @Schema(description = "null: it is not heard, and comes home by its own fail-safe")
            RecoveryView.@Nullable PartView plan,

            @Schema(description = "Names of the drones that it waits for on its way")
            List<String> waitsFor) {}

    /** A drone that is left alone. */
    @Schema(name = "RecoveryLeftOutView", description = "A drone that it leaves alone.")
    public record LeftOutView(
            String drone,
            String droneName,

            @Schema(description = "Why; docs/problems.md lists them")
            String code,

            @Schema(description = "The same as a sentence") String why) {}
}
