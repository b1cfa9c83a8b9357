package org.dronemap.ws.dispatch;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.dispatch.DispatchStage;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** A dispatch (a drone of the pool that was sent to a place) as clients see it. */
@Schema(name = "DispatchView", description = "A drone that was sent to a place, as it stands.")
public record DispatchView(
        String id,

        @Schema(description = "The user who asked, and gets control")
        String owner,

        Instant beganAt,

        @Schema(description = "null: it is under way") @Nullable
        Instant endedAt,

        @Schema(
                description =
                        "chosen: a drone is kept, on the ground; arrived: control goes over to the owner; here: the owner"
                                + " has control; searching: the drone before cannot come, and another one is looked for;"
                                + " returning: none comes any more, and what flew for it flies home")
        @EnumValues(DispatchStage.class)
        String state,

        Instant since,

        @Schema(description = "degrees") double latitude,

        @Schema(description = "degrees") double longitude,

        @Schema(description = "metres above the home of the drone that comes")
        double height,

        @Schema(description = "What is not as it should be") @Nullable
        String note,

        @Schema(description = "Why no drone comes any more, or how it ended") @Nullable
        String end,

        @Schema(description = "The id of the drone that comes or is here; null: none does") @Nullable
        String drone,

        @Nullable String droneName,

        @Schema(description = "What it said, the newest 30, the oldest first; first why this drone was chosen")
        List<NoticeView> told,

        @Schema(description = "Drones that were sent and fly home")
        List<OtherView> others,

        @Schema(description = "How the drone is to the place now; null: none comes") @Nullable
        NowView now) {
    /** Live values of the drone that comes, which change all the time. */
    @Schema(name = "DispatchNowView", description = "What changes all the time; null: nobody knows it.")
    public record NowView(
            @Schema(description = "degrees") @Nullable Double latitude,

            @Schema(description = "degrees") @Nullable Double longitude,

            @Schema(description = "metres above its home") @Nullable
            Double height,

            @Schema(description = "metres on the ground to the place") @Nullable
            Double distance,

            @Schema(
                    description =
                            "seconds until it is there, as far as can be said; null: it is there, or not on its way")
            @Nullable
            Integer seconds,

            @Schema(description = "per cent") @Nullable Integer battery) {}

    /** A drone of it that flies home. */
    @Schema(name = "DispatchOtherView")
    public record OtherView(String drone, String droneName) {}

    /** A sentence of it. */
    @Schema(name = "DispatchToldView")
    public record NoticeView(Instant at, String words) {}
}
