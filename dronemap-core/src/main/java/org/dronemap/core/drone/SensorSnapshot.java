package org.dronemap.core.drone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * The newest range scan, camera image and map of a robot; null where there was none yet. Older ones are not kept.
 * Immutable.
 */
public record SensorSnapshot(
        @Nullable Sample<RangeScan> scan,
        @Nullable Sample<Picture> picture,
        @Nullable Sample<AreaMap> map) {
    public static final SensorSnapshot NOTHING = new SensorSnapshot(null, null, null);

    /**
     * One of them.
     *
     * @param number counts those of its kind from 1
     * @param at when it came
     */
    public record Sample<T>(T value, long number, Instant at) {
        static <T> Sample<T> after(@Nullable Sample<T> before, T value, Instant at) {
            return new Sample<>(value, before == null ? 1 : before.number() + 1, at);
        }
    }

    public SensorSnapshot with(RangeScan newer, Instant at) {
        return new SensorSnapshot(Sample.after(scan, newer, at), picture, map);
    }

    public SensorSnapshot with(Picture newer, Instant at) {
        return new SensorSnapshot(scan, Sample.after(picture, newer, at), map);
    }

    public SensorSnapshot with(AreaMap newer, Instant at) {
        return new SensorSnapshot(scan, picture, Sample.after(map, newer, at));
    }
}
