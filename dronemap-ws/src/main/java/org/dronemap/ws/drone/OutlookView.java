package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.core.cloud.outlook.Outlook;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Forecast of what happens to a drone in the air if it loses whoever controls it, as clients see it. */
@Schema(name = "OutlookView", description = "What becomes of a drone in the air when whoever has it has it no more.")
record OutlookView(
        @Schema(
                description =
                        "kept: somebody has it; waits: nobody has, and it is brought home unless somebody takes it;"
                                + " returns: it is on its way home or down; helpless: nobody has it, and nothing can be done for"
                                + " it; leftAlone: a pilot or another ground station flies it, or the rules say so")
        @EnumValues(Outlook.State.class)
        String state,

        @Schema(description = "A sentence: what happens then")
        String then,

        @Schema(
                description =
                        "When it is brought home unless somebody takes control; null: it does not come to that now")
        @Nullable
        Instant returnsAt,

        @Schema(description = "Where it would be brought down; null: not known, or it would not be") @Nullable
        Double latitude,

        @Nullable Double longitude,

        @Schema(description = "What that place is called, such as home; null: it would not be brought down") @Nullable
        String comesDown,

        @Schema(description = "When its battery is empty, as it has been used up so far; null: not known") @Nullable
        Instant emptyAt) {
    static OutlookView of(Outlook outlook) {
        Geodetic place = outlook.comesDown();
        return new OutlookView(
                WireNames.camel(outlook.state()),
                outlook.then(),
                seconds(outlook.returnsAt()),
                place == null ? null : place.latitudeDegrees(),
                place == null ? null : place.longitudeDegrees(),
                outlook.comesDownWords(),
                seconds(outlook.emptyAt()));
    }

    private static @Nullable Instant seconds(@Nullable Instant instant) {
        return instant == null ? null : instant.truncatedTo(ChronoUnit.SECONDS);
    }
}
