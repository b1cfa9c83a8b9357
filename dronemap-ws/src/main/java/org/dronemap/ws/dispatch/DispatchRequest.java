package org.dronemap.ws.dispatch;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import org.dronemap.cognitive.operation.dispatch.DispatchOrder;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** Request to send a drone of the pool to a place, as a client writes it. Nothing is checked yet. */
@Schema(name = "DispatchRequest", description = "Where a drone is wanted.")
public record DispatchRequest(
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

        @Schema(description = "metres above the home of the drone that comes, 5 to 120; left out: 30")
        @Min((int) DispatchOrder.LOWEST_METERS)
        @Max((int) DispatchOrder.HIGHEST_METERS)
        @Nullable
        Double height,

        @Schema(
                description =
                        "How long it shall be able to stay there, 1 to 60 minutes: so much has to be in the battery"
                                + " beside the way there and back; left out: 5")
        @Min(1)
        @Max(DispatchRequest.MOST_MINUTES)
        @Nullable
        Double minutes) {
    static final int MOST_MINUTES = 60;
    private static final double USUAL_METERS = 30;
    private static final double USUAL_MINUTES = 5;

    DispatchOrder order() {
        Geodetic place =
                new Geodetic(FieldRanges.latitude("latitude", latitude), FieldRanges.longitude("longitude", longitude));
        return new DispatchOrder(
                place,
                FieldRanges.checked(
                        "height",
                        height == null ? (Double) USUAL_METERS : height,
                        (int) DispatchOrder.LOWEST_METERS,
                        (int) DispatchOrder.HIGHEST_METERS,
                        "m"));
    }

    double stayMinutes() {
        return FieldRanges.checked(
                "minutes", minutes == null ? (Double) USUAL_MINUTES : minutes, 1, MOST_MINUTES, "minutes");
    }
}
