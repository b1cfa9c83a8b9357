package org.dronemap.ws.recovery;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.recovery.RecoveryManner;
import org.dronemap.cognitive.operation.recovery.RecoveryOutcome;
import org.dronemap.cognitive.operation.recovery.RecoveryStage;
import org.dronemap.cognitive.operation.recovery.RecoveryStep;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** A recovery (several drones that come home or down together) as clients see it. */
@Schema(name = "RecoveryView", description = "Drones that come home, or down, together, as they stand.")
public record RecoveryView(
        String id,

        @Schema(description = "The user who asked for it") String owner,

        Instant beganAt,

        @Schema(description = "null: it is under way") @Nullable
        Instant endedAt,

        @EnumValues(RecoveryManner.class) String manner,

        @Schema(
                description =
                        "stopping: all drones stop where they are; comingDown: each comes home, or down, in its turn;"
                                + " givingBack: it was called off, and its drones go over to the owner")
        @EnumValues(RecoveryStage.class)
        String state,

        Instant since,

        @Schema(description = "metres above each drone's home: none flies home below")
        double lowest,

        @Schema(description = "metres above each drone's home: none flies home above")
        double ceiling,

        @Schema(description = "Its drones, in the order in which they come down as far as that is planned")
        List<LegView> drones,

        @Schema(description = "What it said, the newest 40, the oldest first")
        List<NoticeView> told,

        @Schema(description = "How it ended; null: it goes on") @Nullable
        String end) {
    /** One drone of a recovery. */
    @Schema(name = "RecoveryDroneView", description = "One drone of it.")
    public record LegView(
            String drone,

            String droneName,

            @Schema(
                    description =
                            "aloft: it stands where it was; levelling: it climbs or descends to its height; level: it"
                                    + " stands there; overHome: it stands above its home")
            @EnumValues(RecoveryStep.class)
            String step,

            @Schema(description = "What became of it; null: it is under way")
            @EnumValues(RecoveryOutcome.class)
            @Nullable
            String outcome,

            @Schema(description = "What is not as it should be, or why it ended so") @Nullable
            String note,

            @Schema(description = "Names of the drones that it waits for now")
            List<String> waitsFor,

            @Schema(description = "Its part of the plan; null: it has none (yet)") @Nullable
            PartView plan) {}

    /** The part of one drone in the plan of a recovery. */
    @Schema(name = "RecoveryPartView", description = "How one drone comes down.")
    public record PartView(
            @Schema(description = "degrees: where it comes down")
            double latitude,

            @Schema(description = "degrees") double longitude,

            @Schema(description = "metres above its home, at which it flies there; when it lands: as high as it is")
            double height,

            @Schema(description = "seconds from the beginning until it leaves its place, as far as can be said")
            double startSeconds,

            @Schema(description = "seconds from the beginning until it is down, as far as can be said")
            double downSeconds) {}

    /** A sentence of it. */
    @Schema(name = "RecoveryToldView")
    public record NoticeView(Instant at, String words) {}
}
