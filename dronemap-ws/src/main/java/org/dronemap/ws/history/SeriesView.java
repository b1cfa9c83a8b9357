package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.SeriesSlot;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/** Telemetry fields over time for charts: one list of times, and lists of least and greatest values for each field. */
@Schema(name = "SeriesView")
public record SeriesView(
        String drone,
        Instant from,
        Instant until,
        double slotSeconds,

        @Schema(description = "Of the first point in each slot that has any")
        List<Instant> times,

        List<FieldSeries> fields) {

    /** The least and the greatest value of each slot, so that no peak is lost; null: not known then. */
    @Schema(name = "FieldSeries")
    public record FieldSeries(String name, String unit, List<@Nullable Double> least, List<@Nullable Double> most) {}

    static SeriesView of(SeriesQuery query, List<SeriesSlot> slots) {
        List<FieldSeries> fields = new ArrayList<>();
        for (int i = 0; i < query.fields().size(); i++) {
            fields.add(field(query.fields().get(i), i, slots));
        }
        return new SeriesView(
                query.drone().value(),
                WireTimes.shown(query.span().from()),
                WireTimes.shown(query.span().until()),
                query.slot().toNanos() / 1e9,
                slots.stream().map(slot -> WireTimes.shown(slot.at())).toList(),
                fields);
    }

    private static FieldSeries field(TelemetryField field, int place, List<SeriesSlot> slots) {
        List<@Nullable Double> least = new ArrayList<>(slots.size());
        List<@Nullable Double> most = new ArrayList<>(slots.size());
        for (SeriesSlot slot : slots) {
            SeriesSlot.Extent extent = slot.extents().get(place);
            least.add(extent == null ? null : extent.least());
            most.add(extent == null ? null : extent.most());
        }
        return new FieldSeries(WireNames.camel(field), field.unit(), least, most);
    }
}
