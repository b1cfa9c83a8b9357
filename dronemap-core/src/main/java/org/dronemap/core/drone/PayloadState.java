package org.dronemap.core.drone;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Last reported state of a vehicle's payload: photo, servo outputs and sensor readings; also the measured wind.
 *
 * @param photo the last one; null: it told of none
 * @param outputs pulses of its outputs from 1 on in microseconds, 0: none; empty: not told
 * @param readings the newest of each sensor, at most {@value #MOST_READINGS}, the one heard last at the end
 * @param wind in its newest flight; null: it told of none
 */
@Stored(names = "photo outputs readings wind")
public record PayloadState(
        @Nullable Photo photo,
        List<Integer> outputs,
        List<Reading> readings,
        @Nullable Wind wind) {
    public static final PayloadState UNKNOWN = new PayloadState(null, List.of(), List.of(), null);
    public static final int MOST_READINGS = 16;

    /** {@code number}: the vehicle's own count; {@code point}: where it was taken, null when it did not say. */
    @Stored(names = "number heard point")
    public record Photo(
            int number, Instant receivedAt, @Nullable Geodetic point) {}

    /** A number under a name, in the unit that the sensor has. */
    @Stored(names = "name value heard")
    public record Reading(String name, double value, Instant receivedAt) {}

    public PayloadState {
        outputs = List.copyOf(outputs);
        readings = List.copyOf(readings);
    }

    public PayloadState with(Photo newer) {
        return new PayloadState(newer, outputs, readings, wind);
    }

    public PayloadState withOutputs(List<Integer> newer) {
        return new PayloadState(photo, newer, readings, wind);
    }

    public PayloadState with(Reading newer) {
        List<Reading> all = new ArrayList<>(readings.stream()
                .filter(reading -> !reading.name().equals(newer.name()))
                .toList());
        if (all.size() == MOST_READINGS) {
            all.remove(0);
        }
        all.add(newer);
        return new PayloadState(photo, outputs, all, wind);
    }

    public PayloadState with(Wind newer) {
        return new PayloadState(photo, outputs, readings, newer);
    }
}
