package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.FlightStatistics;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/** A flight, as clients see it; null: not known, or none. */
@Schema(name = "FlightView")
public record FlightView(
        String id,
        String drone,
        String droneName,
        Instant start,

        @Schema(description = "Null while it goes on; of a lost one, when it was last heard") @Nullable
        Instant end,

        @EnumValues(Flight.State.class) String state,
        double seconds,
        @Schema(description = "Along the ground, in metres") double distance,

        @Schema(description = "Above home, in metres") @Nullable
        Double highest,

        @Schema(description = "Over ground, in m/s") @Nullable
        Double fastest,

        @Schema(description = "From where it was armed, in metres") @Nullable
        Double farthest,

        ChargeView battery,
        @Nullable SpotView takeOff,
        @Nullable SpotView last,

        @Schema(description = "Who commanded it; empty: nobody here")
        List<String> users,

        @Schema(description = "What the cloud conducted with it") @Nullable
        String operation,

        @Nullable String notice,
        String notes,
        @Schema(description = "Ids of recordings of it") List<String> recordings) {

    /** In percent of a full charge. */
    @Schema(name = "FlightChargeView")
    public record ChargeView(
            @Nullable Integer first,
            @Nullable Integer last,
            @Nullable Integer used) {}

    /** In degrees. */
    @Schema(name = "FlightSpotView")
    public record SpotView(double latitude, double longitude) {}

    /** Some flights; {@code next}: go on with before = next, null: that is all. */
    @Schema(name = "Flights")
    public record Flights(
            List<FlightView> flights, @Nullable String next) {}

    static FlightView of(Flight flight, List<String> recordings) {
        FlightStatistics measures = flight.measures();
        Instant until = flight.end() == null ? flight.lastHeardAt() : flight.end();
        Flight.FlightOperation operation = flight.operation();
        return new FlightView(
                flight.id(),
                flight.drone().value(),
                flight.droneName(),
                WireTimes.shown(flight.start()),
                WireTimes.shownOrNull(flight.end()),
                WireNames.camel(flight.state()),
                Duration.between(flight.start(), until).toMillis() / 1000.0,
                tenth(measures.distanceMeters()),
                tenthOrNull(measures.highestMeters()),
                tenthOrNull(measures.fastest()),
                tenthOrNull(measures.farthestMeters()),
                new ChargeView(measures.batteryFirst(), measures.batteryLast(), measures.batteryUsed()),
                place(measures.takeOff()),
                place(measures.last()),
                flight.users(),
                operation == null ? null : operation.words(),
                flight.notice(),
                flight.notes(),
                recordings);
    }

    private static @Nullable SpotView place(@Nullable Geodetic point) {
        return point == null ? null : new SpotView(point.latitudeDegrees(), point.longitudeDegrees());
    }

    private static double tenth(double value) {
        return Math.round(value * 10) / 10.0;
    }

    private static @Nullable Double tenthOrNull(@Nullable Double value) {
        return value == null ? null : (Double) tenth(value);
    }
}
