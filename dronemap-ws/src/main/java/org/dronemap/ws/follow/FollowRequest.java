package org.dronemap.ws.follow;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/**
 * Requests about follows (open, move the drone's place, send positions) as a client writes them. Nothing is checked
 * yet.
 */
public final class FollowRequest {
    private FollowRequest() {}

    /** A phone that asks to be followed. */
    @Schema(
            name = "FollowOpenRequest",
            description = "Where a phone is that asks to be followed, and where the drone is to stay beside it.")
    public record OpenRequest(
            @Schema(description = "degrees", requiredMode = Schema.RequiredMode.REQUIRED)
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(description = "degrees", requiredMode = Schema.RequiredMode.REQUIRED)
            @Min(-FieldRanges.LONGITUDE)
            @Max(FieldRanges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(description = "For people, up to 60 characters; left out: Follow")
            @Size(min = 1, max = FollowReader.LONGEST_NAME)
            @Nullable
            String name,

            @Schema(description = "The id of a drone; left out: the best one of the warehouse is chosen") @Nullable
            String drone,

            @Nullable PlaceRequest place,

            @Schema(
                    description =
                            "How long it shall last, 1 to 60 minutes: so much has to be in the battery; left out: 10")
            @Min(1)
            @Max(FollowReader.MOST_MINUTES)
            @Nullable
            Double minutes,

            @Schema(description = "m/s that the drone flies at most, 1 to 15; left out: 12")
            @Min(1)
            @Max(FollowReader.FASTEST)
            @Nullable
            Double speed,

            @Schema(description = "Without positions for so many seconds the drone flies home, 10 to 600; left out: 60")
            @Min(FollowReader.LEAST_PATIENCE)
            @Max(FollowReader.MOST_PATIENCE)
            @Nullable
            Double patience) {}

    /** Request to set the drone's place relative to the phone. */
    @Schema(
            name = "FollowPlaceRequest",
            description = "Where the drone stays beside the phone; what is left out stays as it is.")
    public record PlaceRequest(
            @Schema(
                    description = "left out at first: behind",
                    allowableValues = {"behind", "ahead", "fixed", "orbit"})
            @Nullable
            String side,

            @Schema(description = "degrees from north to the side where it stays, for fixed")
            @Min(-FollowReader.FULL_CIRCLE)
            @Max(FollowReader.FULL_CIRCLE)
            @Nullable
            Double bearing,

            @Schema(description = "degrees a second clockwise, -30 to 30, for orbit")
            @Min(-FollowReader.MOST_TURN)
            @Max(FollowReader.MOST_TURN)
            @Nullable
            Double turn,

            @Schema(description = "metres on the ground, 0 to 200; left out at first: 8")
            @Min(0)
            @Max(FollowReader.FARTHEST)
            @Nullable
            Double distance,

            @Schema(description = "metres above the drone's home, 5 to 120; left out at first: 15")
            @Min((int) FollowOrder.LOWEST_METERS)
            @Max((int) FollowOrder.HIGHEST_METERS)
            @Nullable
            Double height) {}

    /** Request with positions measured by a phone. */
    @Schema(
            name = "FollowPositionsRequest",
            description = "Where the phone was, oldest first. Times are by its own clock.")
    public record PositionsRequest(
            @Schema(description = "When this is sent", requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            Instant sent,

            @Schema(description = "Milliseconds from sending one to its answer, as measured lately")
            @Min(0)
            @Max(FollowReader.LONGEST_ROUND_TRIP)
            @Nullable
            Double roundTrip,

            @Schema(
                    description = "Up to 60. None: the phone is there, and does not know where it is",
                    requiredMode = Schema.RequiredMode.REQUIRED)
            @Size(max = FollowReader.MOST_POSITIONS)
            @Nullable
            List<@Nullable PositionRequest> positions) {}

    /** One position. */
    @Schema(name = "FollowPositionRequest", description = "Where the phone was once.")
    public record PositionRequest(
            @Schema(
                    description =
                            "Rises from one to the next as long as the follow lasts, so that a position that is said"
                                    + " twice counts once; left out: milliseconds of its time")
            @Min(0)
            @Max(FollowReader.MOST_ID)
            @Nullable
            Long id,

            @Schema(
                    description = "When the phone was there; not more than 60 s after sent",
                    requiredMode = Schema.RequiredMode.REQUIRED)
            @Nullable
            Instant at,

            @Schema(description = "degrees", requiredMode = Schema.RequiredMode.REQUIRED)
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(description = "degrees", requiredMode = Schema.RequiredMode.REQUIRED)
            @Min(-FieldRanges.LONGITUDE)
            @Max(FieldRanges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(
                    description =
                            "metres: it is within them in two cases of three; left out: 10. Above 50 the position leads no"
                                    + " drone")
            @Min(0)
            @Max(FollowReader.WORST_ACCURACY)
            @Nullable
            Double accuracy,

            @Schema(description = "m/s over the ground, 0 to 100; counts with a course")
            @Min(0)
            @Max(FollowReader.FASTEST_PHONE)
            @Nullable
            Double speed,

            @Schema(description = "degrees clockwise from north, -360 to 360; counts with a speed")
            @Min(-FollowReader.FULL_CIRCLE)
            @Max(FollowReader.FULL_CIRCLE)
            @Nullable
            Double course) {}
}
