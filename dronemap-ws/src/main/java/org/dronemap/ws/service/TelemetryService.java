package org.dronemap.ws.service;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.Span;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;

/** Use cases around what was measured and what happened, of a drone over some time or of one flight. Any thread. */
public final class TelemetryService {
    private static final Duration USUAL = Duration.ofHours(1);
    /** Commands are given before what comes of them. */
    private static final Duration MARGIN = Duration.ofSeconds(10);

    private static final int MOST_EVENTS = 5_000;
    private static final int MOST_IN_A_FILE = 100_000;

    private final TelemetryStore store;
    private final DroneService drones;
    private final FlightService flights;
    private final TlogCut tlog;
    private final Path temporaryDirectory;
    private final InstantSource clock;

    /** Whose telemetry is asked for, and when it usually is looked at. */
    public record Subject(DroneId drone, String name, Span usual) {}

    /** A file that belongs to the caller from now on. */
    public record Export(Path file, String name, String mediaType) {}

    public TelemetryService(
            TelemetryStore store,
            DroneService drones,
            FlightService flights,
            TlogCut tlog,
            Path temporaryDirectory,
            InstantSource clock) {
        this.store = store;
        this.drones = drones;
        this.flights = flights;
        this.tlog = tlog;
        this.temporaryDirectory = temporaryDirectory;
        this.clock = clock;
    }

    /** A drone, over the last hour. */
    public Subject drone(Principal principal, String id) {
        DroneState state = drones.state(principal, id);
        Instant now = clock.instant();
        return new Subject(state.id(), state.name(), new Span(now.minus(USUAL), now));
    }

    /** A flight, from its beginning to its end or to now. */
    public Subject flight(Principal principal, String id) {
        Flight flight = flights.find(principal, id);
        Instant end = flight.end() == null ? clock.instant() : flight.end();
        // The moment of the end is the flight's, too.
        Instant until = end.plusMillis(1);
        return new Subject(flight.drone(), flight.droneName(), new Span(flight.start(), max(flight.start(), until)));
    }

    public SeriesView series(Subject subject, TelemetrySearch search) {
        SeriesQuery query =
                new SeriesQuery(subject.drone(), search.span(subject.usual()), search.chosen(), search.slotCount());
        return SeriesView.of(query, store.series(query));
    }

    /** All points, or so many of them that they are no more than is asked for, evenly over the time. */
    public PointView.Points points(Subject subject, TelemetrySearch search) {
        Span span = search.span(subject.usual());
        Duration apart = span.length().dividedBy(search.mostPoints());
        List<PointView> points = new ArrayList<>();
        Instant[] next = {span.from()};
        store.points(subject.drone(), span, point -> {
            if (!point.at().isBefore(next[0])) {
                points.add(PointView.of(point));
                next[0] = point.at().plus(apart);
            }
        });
        return new PointView.Points(
                subject.drone().value(), WireTimes.shown(span.from()), WireTimes.shown(span.until()), points);
    }

    public EventView.Events events(Subject subject, TelemetrySearch search) {
        Span span = search.span(around(subject.usual()));
        List<HistoryEvent> events = store.events(subject.drone(), span, MOST_EVENTS + 1);
        return new EventView.Events(
                subject.drone().value(),
                WireTimes.shown(span.from()),
                WireTimes.shown(span.until()),
                events.stream().limit(MOST_EVENTS).map(EventView::of).toList(),
                events.size() > MOST_EVENTS);
    }

    private static Span around(Span span) {
        return new Span(span.from().minus(MARGIN), span.until().plus(MARGIN));
    }

    /** Whole before its first byte is handed out, so that a slow reader holds nothing up. */
    public Export export(Subject subject, TelemetrySearch search, String form) throws IOException {
        Span span = search.span(subject.usual());
        if (form.equals(TlogCut.FORM)) {
            Path file = made(TlogCut.FORM, path -> tlog.write(subject.drone(), span, path));
            return new Export(file, name(subject, span, TlogCut.FORM), "application/octet-stream");
        }
        TrackForm kind = TrackForm.named(form);
        Path file = made(kind.ending(), path -> {
            try (BufferedWriter out = Files.newBufferedWriter(path)) {
                kind.write(track(subject, span, kind), out);
            }
        });
        return new Export(file, name(subject, span, kind.ending()), kind.mediaType());
    }

    private TrackForm.Track track(Subject subject, Span span, TrackForm kind) {
        return new TrackForm.Track(
                subject.name(),
                points(subject.drone(), span),
                kind.hasEvents() ? store.events(subject.drone(), span, MOST_EVENTS) : List.of());
    }

    private interface Making {
        void into(Path file) throws IOException;
    }

    private Path made(String ending, Making making) throws IOException {
        Path file = Files.createTempFile(temporaryDirectory, "telemetry", "." + ending);
        try {
            making.into(file);
            return file;
        } catch (IOException | RuntimeException e) {
            Files.deleteIfExists(file);
            throw e;
        }
    }

    private static String name(Subject subject, Span span, String ending) {
        return subject.name().replaceAll("[^A-Za-z0-9-]+", "-") + "_"
                + WireTimes.shown(span.from()).toString().replaceAll("[^0-9TZ]", "") + "." + ending;
    }

    private List<TelemetryPoint> points(DroneId drone, Span span) {
        List<TelemetryPoint> points = new ArrayList<>();
        store.points(drone, span, point -> {
            if (points.size() == MOST_IN_A_FILE) {
                throw new InvalidInput(
                        "until",
                        "a time that leaves no more than " + MOST_IN_A_FILE + " points",
                        "That is more than " + MOST_IN_A_FILE + " points; ask for a shorter time.");
            }
            points.add(point);
        });
        return points;
    }

    private static Instant max(Instant one, Instant other) {
        return one.isAfter(other) ? one : other;
    }
}
