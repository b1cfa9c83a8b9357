package org.dronemap.ws.history;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import org.dronemap.core.access.HistoryVisibility;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.VisibilityLevel;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.ws.drone.DroneEventView;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.TelemetryPointView;
import org.dronemap.ws.reading.WireTimes;

/** Reads stored telemetry and events of a drone or of one flight, for users who may see them. Any thread. */
public final class TelemetryService {
    private static final Duration USUAL = Duration.ofHours(1);
    /** Commands are given before what comes of them. */
    private static final Duration MARGIN = Duration.ofSeconds(10);

    private static final int MOST_EVENTS = 5_000;

    private final TelemetryStore store;
    private final DroneService drones;
    private final FlightService flights;
    private final InstantSource clock;

    /** Drone whose telemetry is requested, with the default time range and the periods that the caller may see. */
    public record Subject(DroneId drone, String name, TimeRange usual, HistoryVisibility insight) {
        /** What is asked for, all of which has to be shown to the asker. */
        TimeRange span(TelemetrySearchRequest search) {
            return span(search, usual);
        }

        private TimeRange span(TelemetrySearchRequest search, TimeRange usually) {
            TimeRange asked = search.span(shown(usually));
            TimeRange shown = shown(asked);
            if (!shown.equals(asked) && !asked.length().isZero()) {
                throw new InvalidInput(
                        ValueProblem.TIME_NOT_SHOWN,
                        "from",
                        "a time that is shown to you",
                        "The drone was another organisation's then"
                                + (shown.length().isZero()
                                        ? "."
                                        : "; ask from " + shown.from() + " until " + shown.until() + "."));
            }
            return asked;
        }

        private TimeRange shown(TimeRange span) {
            return insight.within(span.from(), span.until())
                    .map(part -> new TimeRange(part.from(), part.until()))
                    .orElse(new TimeRange(span.until(), span.until()));
        }

        HistoryEvent shown(HistoryEvent event) {
            return insight.at(event.at()) == VisibilityLevel.ALL ? event : NameRedaction.event(event);
        }
    }

    public TelemetryService(TelemetryStore store, DroneService drones, FlightService flights, InstantSource clock) {
        this.store = store;
        this.drones = drones;
        this.flights = flights;
        this.clock = clock;
    }

    /** A drone, over the last hour. */
    public Subject drone(Principal principal, String id) {
        DroneState state = drones.state(principal, id);
        Instant now = clock.instant();
        return new Subject(
                state.id(), state.name(), new TimeRange(now.minus(USUAL), now), principal.insight(state.id()));
    }

    /** A flight, from its beginning to its end or to now. */
    public Subject flight(Principal principal, String id) {
        Flight flight = flights.find(principal, id);
        Instant end = flight.end() == null ? clock.instant() : flight.end();
        // The moment of the end is the flight's, too.
        Instant until = end.plusMillis(1);
        return new Subject(
                flight.drone(),
                flight.droneName(),
                new TimeRange(flight.start(), max(flight.start(), until)),
                principal.insight(flight.drone()));
    }

    public SeriesView series(Subject subject, TelemetrySearchRequest search) {
        SeriesQuery query = new SeriesQuery(subject.drone(), subject.span(search), search.chosen(), search.slotCount());
        return SeriesView.of(query, store.series(query));
    }

    /** All points, or so many of them that they are no more than is asked for, evenly over the time. */
    public TelemetryPointView.Points points(Subject subject, TelemetrySearchRequest search) {
        TimeRange span = subject.span(search);
        EvenPoints points = new EvenPoints(span, search.mostPoints());
        store.points(subject.drone(), span, points::add);
        return new TelemetryPointView.Points(
                subject.drone().value(),
                WireTimes.shown(span.from()),
                WireTimes.shown(span.until()),
                points.chosen().stream().map(TelemetryPointView::of).toList());
    }

    public DroneEventView.Events events(Subject subject, TelemetrySearchRequest search) {
        TimeRange span = subject.span(search, around(subject.usual()));
        List<HistoryEvent> events = store.events(subject.drone(), span, MOST_EVENTS + 1);
        return new DroneEventView.Events(
                subject.drone().value(),
                WireTimes.shown(span.from()),
                WireTimes.shown(span.until()),
                events.stream()
                        .limit(MOST_EVENTS)
                        .map(subject::shown)
                        .map(DroneEventView::of)
                        .toList(),
                events.size() > MOST_EVENTS);
    }

    private static TimeRange around(TimeRange span) {
        return new TimeRange(span.from().minus(MARGIN), span.until().plus(MARGIN));
    }

    private static Instant max(Instant one, Instant other) {
        return one.isAfter(other) ? one : other;
    }
}
