package org.dronemap.core.history;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Thins old telemetry of a drone: of each interval keeps the first point and those with peak values. Points come drone
 * by drone, each in the order of time. One thread.
 */
public final class TelemetryDownsampler {
    private static final List<TelemetryField> PEAKS = List.of(
            TelemetryField.ALTITUDE_ABOVE_HOME,
            TelemetryField.GROUND_SPEED,
            TelemetryField.CLIMB_RATE,
            TelemetryField.BATTERY_PERCENT,
            TelemetryField.BATTERY_VOLTS,
            TelemetryField.LOSS_SHORT);

    private final long stretchMillis;
    private final Consumer<TelemetryPoint> kept;
    private final List<TelemetryPoint> stretch = new ArrayList<>();
    private @Nullable DroneId drone;
    private long index;

    public TelemetryDownsampler(Duration stretch, Consumer<TelemetryPoint> kept) {
        this.stretchMillis = stretch.toMillis();
        this.kept = kept;
    }

    public void add(TelemetryPoint point) {
        long at = stretchOf(point.at());
        if (!point.drone().equals(drone) || at != index) {
            finish();
            drone = point.drone();
            index = at;
        }
        stretch.add(point);
    }

    /** Gives out what the last stretch leaves. */
    public void finish() {
        if (stretch.isEmpty()) {
            return;
        }
        boolean[] keep = new boolean[stretch.size()];
        keep[0] = true;
        PEAKS.forEach(field -> markPeaks(field, keep));
        for (int i = 0; i < keep.length; i++) {
            if (keep[i]) {
                kept.accept(stretch.get(i));
            }
        }
        stretch.clear();
    }

    private void markPeaks(TelemetryField field, boolean[] keep) {
        int least = -1;
        int most = -1;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < keep.length; i++) {
            Double value = field.of(stretch.get(i));
            if (value != null && value < low) {
                low = value;
                least = i;
            }
            if (value != null && value > high) {
                high = value;
                most = i;
            }
        }
        if (least >= 0 && most >= 0) {
            keep[least] = true;
            keep[most] = true;
        }
    }

    private long stretchOf(Instant at) {
        return Math.floorDiv(at.toEpochMilli(), stretchMillis);
    }
}
