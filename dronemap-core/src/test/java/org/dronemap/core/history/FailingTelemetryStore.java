package org.dronemap.core.history;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Telemetry that a test can look at, in a store that it can break or hold up. */
final class FailingTelemetryStore implements TelemetryStore {
    final List<TelemetryPoint> points = new CopyOnWriteArrayList<>();
    final List<HistoryEvent> events = new CopyOnWriteArrayList<>();
    final List<EventLoss> losses = new CopyOnWriteArrayList<>();
    /** Somebody stores events, and has not said that all are. */
    volatile boolean open;

    volatile boolean openedBefore;
    final List<Integer> batches = new CopyOnWriteArrayList<>();
    volatile boolean broken;
    /** It comes back just when it is asked what it is. */
    volatile boolean backWhenAsked;
    /** It answers, but never takes an event with this text. */
    volatile String poison = "";

    volatile CountDownLatch disk = new CountDownLatch(0);

    @Override
    public void append(List<TelemetryPoint> newPoints, List<HistoryEvent> newEvents, @Nullable EventLoss lost) {
        try {
            disk.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        if (broken) {
            throw new IllegalStateException("the disk is full");
        }
        if (newEvents.stream().anyMatch(event -> event.text().equals(poison))) {
            throw new IllegalStateException("not that");
        }
        batches.add(newPoints.size());
        points.addAll(newPoints);
        events.addAll(newEvents);
        if (lost != null) {
            losses.add(lost);
        }
    }

    @Override
    public void openEvents(Instant now) {
        openedBefore = open;
        open = true;
    }

    @Override
    public void closeEvents() {
        open = false;
    }

    @Override
    public EventPage eventsAfter(long number, int limit) {
        List<NumberedEvent> numbered = IntStream.range(0, events.size())
                .mapToObj(i -> new NumberedEvent(i + 1L, events.get(i)))
                .filter(event -> event.number() > number)
                .limit(limit)
                .toList();
        return EventPage.of(new EventSeries("heap", events.size(), 0, null), number, limit, numbered, List.of());
    }

    @Override
    public void points(DroneId drone, TimeRange span, Consumer<TelemetryPoint> each) {
        points.stream().filter(point -> span.contains(point.at())).forEach(each);
    }

    @Override
    public List<SeriesSlot> series(SeriesQuery query) {
        SeriesBuilder builder = new SeriesBuilder(query);
        points(query.drone(), query.span(), builder::add);
        return builder.slots();
    }

    @Override
    public List<HistoryEvent> events(DroneId drone, TimeRange span, int limit) {
        return events;
    }

    @Override
    public void tidy(Retention retention, Instant now) {
        if (broken) {
            throw new IllegalStateException("the disk is full");
        }
    }

    @Override
    public String server() {
        broken = broken && !backWhenAsked;
        if (broken) {
            throw new IllegalStateException("the disk is full");
        }
        return "heap";
    }
}
