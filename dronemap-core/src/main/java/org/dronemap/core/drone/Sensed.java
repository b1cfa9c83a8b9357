package org.dronemap.core.drone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** The newest that a vehicle's sensors brought; null where there was none yet. Older ones are not kept. Immutable. */
public record Sensed(
        @Nullable Kept<RangeScan> scan,
        @Nullable Kept<Picture> picture,
        @Nullable Kept<AreaMap> map) {
    public static final Sensed NOTHING = new Sensed(null, null, null);

    /**
     * One of them.
     *
     * @param number counts those of its kind from 1
     * @param at when it came
     */
    public record Kept<T>(T value, long number, Instant at) {
        static <T> Kept<T> after(@Nullable Kept<T> before, T value, Instant at) {
            return new Kept<>(value, before == null ? 1 : before.number() + 1, at);
        }
    }

    public Sensed with(RangeScan newer, Instant at) {
        return new Sensed(Kept.after(scan, newer, at), picture, map);
    }

    public Sensed with(Picture newer, Instant at) {
        return new Sensed(scan, Kept.after(picture, newer, at), map);
    }

    public Sensed with(AreaMap newer, Instant at) {
        return new Sensed(scan, picture, Kept.after(map, newer, at));
    }
}
