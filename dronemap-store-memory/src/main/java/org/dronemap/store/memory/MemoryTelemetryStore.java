package org.dronemap.store.memory;

import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.SeriesBuilder;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.SeriesSlot;
import org.dronemap.core.history.TelemetryDownsampler;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/** Keeps telemetry and drones' events in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryTelemetryStore implements TelemetryStore {
    private final Map<DroneId, NavigableMap<Instant, TelemetryPoint>> points = new HashMap<>();
    private final MemoryEventSeries events = new MemoryEventSeries();

    @Override
    public synchronized void append(
            List<TelemetryPoint> newPoints, List<HistoryEvent> newEvents, @Nullable EventLoss lost) {
        newPoints.stream()
                .map(MemoryTelemetryStore::stored)
                .forEach(point -> points.computeIfAbsent(point.drone(), drone -> new TreeMap<>())
                        .putIfAbsent(point.at(), point));
        events.append(newEvents.stream().map(MemoryTelemetryStore::stored).toList(), lost);
    }

    @Override
    public synchronized void points(DroneId drone, TimeRange span, Consumer<TelemetryPoint> each) {
        NavigableMap<Instant, TelemetryPoint> known = points.get(drone);
        if (known != null) {
            known.subMap(span.from(), true, span.until(), false).values().forEach(each);
        }
    }

    @Override
    public synchronized List<SeriesSlot> series(SeriesQuery query) {
        SeriesBuilder builder = new SeriesBuilder(query);
        points(query.drone(), query.span(), builder::add);
        return builder.slots();
    }

    @Override
    public synchronized List<HistoryEvent> events(DroneId drone, TimeRange span, int limit) {
        return events.all()
                .filter(event -> event.drone().equals(drone) && span.contains(event.at()))
                .sorted((one, other) -> one.at().compareTo(other.at()))
                .limit(limit)
                .toList();
    }

    @Override
    public synchronized void openEvents(Instant now) {
        events.open(StoredInstant.of(now));
    }

    @Override
    public synchronized void closeEvents() {
        events.close();
    }

    @Override
    public synchronized EventPage eventsAfter(long number, int limit) {
        return events.after(number, limit);
    }

    @Override
    public synchronized void tidy(Retention retention, Instant now) {
        Instant kept = begin(retention.firstKept(now));
        Instant full = begin(retention.firstFull(now));
        events.drop(kept);
        for (NavigableMap<Instant, TelemetryPoint> known : points.values()) {
            known.headMap(kept, false).clear();
            NavigableMap<Instant, TelemetryPoint> old = known.headMap(full, false);
            Map<Instant, TelemetryPoint> thinned = new TreeMap<>();
            TelemetryDownsampler thinning =
                    new TelemetryDownsampler(retention.thinned(), point -> thinned.put(point.at(), point));
            old.values().forEach(thinning::add);
            thinning.finish();
            old.values().retainAll(thinned.values());
        }
        points.values().removeIf(Map::isEmpty);
    }

    private static Instant begin(@Nullable LocalDate day) {
        return day == null ? Instant.MIN : day.atStartOfDay(ZoneOffset.UTC).toInstant();
    }

    @Override
    public String server() {
        return "memory";
    }

    private static TelemetryPoint stored(TelemetryPoint point) {
        return new TelemetryPoint(
                point.drone(),
                StoredInstant.of(point.at()),
                point.position(),
                point.motion(),
                point.attitude(),
                point.battery(),
                point.gps(),
                point.link(),
                point.quality(),
                point.mode(),
                point.armed(),
                point.phase(),
                point.missionItem());
    }

    private static HistoryEvent stored(HistoryEvent event) {
        return new HistoryEvent(
                event.drone(),
                StoredInstant.of(event.at()),
                event.kind(),
                event.text(),
                event.severity(),
                event.by(),
                event.command(),
                event.result(),
                event.reason());
    }
}
