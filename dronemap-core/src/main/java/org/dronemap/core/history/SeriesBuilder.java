package org.dronemap.core.history;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Reduces telemetry points to a time series for drawing, for stores that cannot do it themselves. One thread. */
public final class SeriesBuilder {
    private final SeriesQuery query;
    private final long slotNanos;
    private final List<SeriesSlot> slots = new ArrayList<>();
    private long index = -1;
    private @Nullable Instant first;
    private SeriesSlot.@Nullable Extent[] extents;

    public SeriesBuilder(SeriesQuery query) {
        this.query = query;
        this.slotNanos = query.slot().toNanos();
        this.extents = new SeriesSlot.Extent[query.fields().size()];
    }

    /** In the order of time. */
    public void add(TelemetryPoint point) {
        long slot = Duration.between(query.span().from(), point.at()).toNanos() / slotNanos;
        if (slot != index) {
            close();
            index = slot;
            first = point.at();
        }
        for (int i = 0; i < extents.length; i++) {
            Double value = query.fields().get(i).of(point);
            if (value != null) {
                SeriesSlot.Extent before = extents[i];
                extents[i] = before == null ? new SeriesSlot.Extent(value, value) : before.with(value);
            }
        }
    }

    public List<SeriesSlot> slots() {
        close();
        index = -1;
        return List.copyOf(slots);
    }

    private void close() {
        if (first != null) {
            slots.add(new SeriesSlot(first, Arrays.asList(extents.clone())));
        }
        first = null;
        extents = new SeriesSlot.Extent[query.fields().size()];
    }
}
