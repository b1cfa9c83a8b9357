package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.LeaseRequest;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Control of a drone as clients see it. */
@Schema(name = "ControlView", description = "Who commands a drone.")
public record ControlView(
        @Schema(
                description = "held: by the user in holder; pilot: by whoever flies it at the vehicle",
                allowableValues = {"free", "held", "pilot"})
        String state,

        @Nullable String holder,

        @Schema(
                description =
                        "Taken on purpose and kept by heartbeats; else it came with a command and ends 30 s later, in the"
                                + " air once its user looks at the drone no more as well")
        boolean explicit,

        @Nullable Instant since,

        @Schema(description = "Rises with each new holder; a command of an older one is not sent any more")
        long epoch,

        @Schema(description = "Who asks the holder for control, oldest first")
        List<RequestView> requests) {

    /** Somebody asks for control. */
    @Schema(name = "ControlAskedView")
    public record RequestView(String by, @Nullable String reason, Instant at) {
        static RequestView of(LeaseRequest request) {
            return new RequestView(request.by(), request.reason(), millis(request.at()));
        }
    }

    /** Change of control: who did it or is affected by it, and who else is concerned; null: the pilot, or nobody. */
    @Schema(name = "ControlChangeView", description = "What happened to the control of a drone.")
    public record ChangeView(
            @EnumValues(ControlChange.Kind.class) String kind,

            @Schema(description = "Who did it, or whom it befell; null: the pilot") @Nullable
            String by,

            @Schema(description = "Who had it before, or who gets it; null: nobody else") @Nullable
            String other,

            @Nullable String reason) {
        public static ChangeView of(ControlChange change) {
            return new ChangeView(
                    WireNames.camel(change.kind()), name(change.by()), name(change.other()), change.reason());
        }
    }

    public static ControlView of(ControlState control) {
        Lease tenure = control.tenure();
        return new ControlView(
                state(tenure),
                tenure == null ? null : name(tenure.holder()),
                tenure != null && tenure.explicit(),
                tenure == null ? null : millis(tenure.since()),
                control.epoch(),
                control.requests().stream().map(RequestView::of).toList());
    }

    private static String state(@Nullable Lease tenure) {
        if (tenure == null) {
            return "free";
        }
        return tenure.holder() instanceof LeaseHolder.Pilot ? "pilot" : "held";
    }

    private static @Nullable String name(@Nullable LeaseHolder holder) {
        return holder == null ? null : holder.label().orElse(null);
    }

    private static Instant millis(Instant instant) {
        return instant.truncatedTo(ChronoUnit.MILLIS);
    }
}
