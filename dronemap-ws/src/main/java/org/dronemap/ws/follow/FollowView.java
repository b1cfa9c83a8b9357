package org.dronemap.ws.follow;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.cognitive.operation.follow.FollowStage;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** A follow (a drone that follows a phone) as clients see it. */
@Schema(name = "FollowView", description = "A phone that a drone follows, as it stands.")
public record FollowView(
        String id,
        String name,

        @Schema(description = "The user whose phone it is") String owner,

        Instant beganAt,

        @Schema(description = "null: it is under way") @Nullable
        Instant endedAt,

        @Schema(description = "allocated: a drone is kept on the ground; suspended: somebody else has the drone")
        @EnumValues(FollowStage.class)
        String state,

        Instant since,

        @Schema(description = "What is not as it should be") @Nullable
        String note,

        @Schema(description = "How it ended") @Nullable String end,

        String drone,
        String droneName,
        PlaceView place,

        @Schema(description = "seconds without a position before the drone flies home")
        int patience,

        @Schema(description = "What it said, the newest 30, the oldest first; first why this drone was chosen")
        List<NoticeView> told,

        @Schema(
                description =
                        "Other drones of it: one that comes to replace this one, or that was replaced and flies home")
        List<OtherView> others,

        @Schema(description = "How drone and phone are to each other now; null: it is over") @Nullable
        NowView now) {
    /** Another drone of the same follow. */
    @Schema(name = "FollowOtherView")
    public record OtherView(
            String drone,
            String droneName,

            @Schema(description = "As of a follow: starting, tracking, suspended or returning")
            @EnumValues(FollowStage.class)
            String state,

            @Schema(description = "It is on its way to replace the drone that follows; false: it flies home")
            boolean comes) {}

    /** Place of the drone relative to the phone. */
    @Schema(name = "FollowPlaceView")
    public record PlaceView(
            @Schema(allowableValues = {"behind", "ahead", "fixed", "orbit"})
            String side,

            @Schema(description = "degrees from north, for fixed") @Nullable
            Double bearing,

            @Schema(description = "degrees a second clockwise, for orbit") @Nullable
            Double turn,

            @Schema(description = "metres") double distance,

            @Schema(description = "metres above the drone's home")
            double height) {}

    /** Live values of a follow, which change all the time; null: not known. */
    @Schema(name = "FollowNowView", description = "What changes all the time; null: nobody knows it.")
    public record NowView(
            @Nullable FollowPointView droneAt,

            @Schema(description = "metres above its home") @Nullable
            Double height,

            @Schema(description = "metres on the ground from the drone to where the phone said last that it is")
            @Nullable
            Double distance,

            @Schema(description = "per cent") @Nullable Integer battery,

            @Schema(
                    description =
                            "until the drone has to fly home with what is in its battery, if it stays as far away")
            @Nullable
            Integer secondsLeft,

            @Nullable PhoneView phone,

            @Schema(
                    description =
                            "How the phone is reached on the stream: vague: where it says it is is of no use; asleep: its page"
                                    + " stands still; cut: it has no network; gone: its page was closed; null: it does"
                                    + " not speak there")
            @EnumValues(ReporterState.class)
            @Nullable
            String reach) {}

    /** Degrees. */
    @Schema(name = "FollowPointView")
    public record FollowPointView(double latitude, double longitude) {}

    /** Last position reported by the phone. */
    @Schema(name = "FollowPhoneView")
    public record PhoneView(
            FollowPointView at,

            @Schema(description = "metres") double accuracy,

            @Schema(description = "The id of that position") long id,

            @Schema(description = "When the cloud heard it") Instant heard) {}

    /** A sentence of it. */
    @Schema(name = "FollowToldView")
    public record NoticeView(Instant at, String words) {}

    static FollowView of(Snapshot<FollowState> follow, @Nullable NowView now) {
        FollowState state = follow.state();
        Instant ended = follow.saved().endedAt();
        return new FollowView(
                follow.saved().id().value(),
                follow.saved().name(),
                follow.saved().owner(),
                millis(follow.saved().beganAt()),
                ended == null ? null : millis(ended),
                WireNames.camel(follow.setAside() == null ? state.stage() : FollowStage.OVER),
                millis(state.since()),
                state.note(),
                follow.setAside() == null ? state.end() : follow.setAside(),
                state.drone().value(),
                state.order().chosen().name(),
                place(state.order().place()),
                state.order().patienceSeconds(),
                state.notices().stream()
                        .map(one -> new NoticeView(millis(one.at()), one.words()))
                        .toList(),
                state.reliefOrNone().others().stream()
                        .map(other -> new OtherView(
                                other.drone().value(),
                                other.droneName(),
                                WireNames.camel(other.stage()),
                                other.isComing(state)))
                        .toList(),
                now);
    }

    private static PlaceView place(FollowOrder.RelativePlace place) {
        StandOffSide side = place.side();
        return new PlaceView(
                WireNames.lowerFirst(side.getClass().getSimpleName()),
                side instanceof StandOffSide.Fixed fixed ? fixed.bearingDegrees() : null,
                side instanceof StandOffSide.Orbit orbit ? orbit.degreesPerSecond() : null,
                place.distanceMeters(),
                place.heightMeters());
    }

    private static Instant millis(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS);
    }
}
