package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.cognitive.follow.Side;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.conduct.Operations.Picture;
import org.jspecify.annotations.Nullable;

/** A follow as clients see it. */
@Schema(description = "A phone that a drone follows, as it stands.")
public record FollowView(
        String id,
        String name,

        @Schema(description = "The user whose phone it is") String owner,

        Instant beganAt,

        @Schema(description = "null: it is under way") @Nullable
        Instant endedAt,

        @Schema(
                description =
                        "allocated: a drone is kept on the ground; starting, tracking, paused, suspended: somebody else has"
                                + " the drone; returning or over")
        String state,

        Instant since,

        @Schema(description = "What is not as it should be") @Nullable
        String note,

        @Schema(description = "How it ended") @Nullable String end,

        String drone,
        String droneName,
        PlaceView place,

        @Schema(description = "What it said, the newest 30, the oldest first; first why this drone was chosen")
        List<ToldView> told) {
    /** Where the drone stays. */
    @Schema(name = "FollowPlaceView")
    public record PlaceView(
            @Schema(description = "behind, ahead, fixed or orbit")
            String side,

            @Schema(description = "degrees from north, for fixed") @Nullable
            Double bearing,

            @Schema(description = "degrees a second clockwise, for orbit") @Nullable
            Double turn,

            @Schema(description = "metres") double distance,

            @Schema(description = "metres above the drone's home")
            double height) {}

    /** A sentence of it. */
    @Schema(name = "FollowToldView")
    public record ToldView(Instant at, String words) {}

    static FollowView of(Picture<FollowState> follow) {
        FollowState state = follow.state();
        Instant ended = follow.saved().endedAt();
        return new FollowView(
                follow.saved().id().value(),
                follow.saved().name(),
                follow.saved().owner(),
                millis(follow.saved().beganAt()),
                ended == null ? null : millis(ended),
                WireNames.camel(state.stage()),
                millis(state.since()),
                state.note(),
                state.end(),
                state.drone().value(),
                state.order().chosen().name(),
                place(state.order().place()),
                state.told().stream()
                        .map(one -> new ToldView(millis(one.at()), one.words()))
                        .toList());
    }

    private static PlaceView place(FollowOrder.Place place) {
        Side side = place.side();
        return new PlaceView(
                WireNames.lowerFirst(side.getClass().getSimpleName()),
                side instanceof Side.Fixed fixed ? fixed.bearingDegrees() : null,
                side instanceof Side.Orbit orbit ? orbit.degreesPerSecond() : null,
                place.distanceMeters(),
                place.heightMeters());
    }

    private static Instant millis(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS);
    }
}
