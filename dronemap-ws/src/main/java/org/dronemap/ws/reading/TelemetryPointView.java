package org.dronemap.ws.reading;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.jspecify.annotations.Nullable;

/** The stored state of a drone at one moment, as maps with a time line need it; null: not known. */
@Schema(name = "PointView")
public record TelemetryPointView(
        Instant at,
        @Nullable Double latitude,
        @Nullable Double longitude,
        @Nullable Double altitudeAmsl,
        @Nullable Double altitudeAboveHome,
        @Nullable Double heading,
        @Nullable Double groundSpeed,
        @Nullable Double climbRate,
        @Nullable Integer batteryPercent,
        @Nullable Boolean armed,
        @Nullable String mode,
        @EnumValues(FlightPhase.class) @Nullable String flight,
        @EnumValues(LinkState.class) String link) {

    /** In the order of time. */
    @Schema(name = "Points")
    public record Points(String drone, Instant from, Instant until, List<TelemetryPointView> points) {}

    public static TelemetryPointView of(TelemetryPoint point) {
        return new TelemetryPointView(
                WireTimes.shown(point.at()),
                TelemetryField.LATITUDE.of(point),
                TelemetryField.LONGITUDE.of(point),
                TelemetryField.ALTITUDE_AMSL.of(point),
                TelemetryField.ALTITUDE_ABOVE_HOME.of(point),
                TelemetryField.HEADING.of(point),
                TelemetryField.GROUND_SPEED.of(point),
                TelemetryField.CLIMB_RATE.of(point),
                point.battery() == null ? null : point.battery().percent(),
                point.armed(),
                point.mode(),
                point.phase() == null ? null : WireNames.camel(point.phase()),
                WireNames.camel(point.link()));
    }
}
