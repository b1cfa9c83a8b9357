package org.dronemap.ws.reading;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.TelemetryPoint;

/** Picks the telemetry points of a track that have a position, and finds the one at a given time. */
public final class PositionedPoints {
    private PositionedPoints() {}

    public static List<TelemetryPoint> of(List<TelemetryPoint> points) {
        return points.stream()
                .filter(point -> point.position() != null && point.position().point() != null)
                .toList();
    }

    /** Of one of those. */
    public static Geodetic place(TelemetryPoint point) {
        Position position = Objects.requireNonNull(point.position());
        return Objects.requireNonNull(position.point());
    }

    /** The last of them by then, or else the first one; empty: there is none. */
    public static Optional<TelemetryPoint> at(List<TelemetryPoint> placed, Instant time) {
        if (placed.isEmpty()) {
            return Optional.empty();
        }
        int low = 0;
        int high = placed.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (placed.get(middle).at().isAfter(time)) {
                high = middle - 1;
            } else {
                low = middle;
            }
        }
        return Optional.of(placed.get(low));
    }
}
