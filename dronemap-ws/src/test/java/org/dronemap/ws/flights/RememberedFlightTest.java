package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.ws.drone.DroneEventView;
import org.dronemap.ws.history.FlightSearchRequest;
import org.dronemap.ws.history.FlightView;
import org.dronemap.ws.history.TelemetrySearchRequest;
import org.dronemap.ws.history.TelemetryService;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkFrameLog;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.reading.TelemetryPointView;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Flights remembered: what is found and taken along later is what was on the wire, also over a crash of the server. */
class RememberedFlightTest {
    private static final double METERS = 1;
    private static final Duration IN_TIME = Duration.ofMillis(200);
    /** What a crash of the server may cost. */
    private static final Duration MOST_LOST = Duration.ofSeconds(1);

    private static final TelemetrySearchRequest ALL = new TelemetrySearchRequest(null, null, null, null, null);
    private static final FlightSearchRequest ANY = new FlightSearchRequest(null, null, null, null, null);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone copter = lab.copter();
    private final Instant began = lab.now().minusNanos(lab.time().nanos());

    @AfterEach
    void close() {
        lab.close();
    }

    private List<FlightView> flights() {
        return lab.server()
                .office()
                .flights()
                .page(ann.principal(), ANY, null, null)
                .flights();
    }

    private FlightView flight(String state) {
        return lab.until(
                "the flight is " + state,
                Duration.ofMinutes(2),
                () -> flights().stream()
                        .findFirst()
                        .filter(flight -> flight.state().equals(state)));
    }

    private TelemetryService telemetry() {
        return lab.server().office().telemetry();
    }

    private TelemetryService.Subject subject(FlightView flight) {
        return telemetry().flight(ann.principal(), flight.id());
    }

    private FlightView fly() {
        ann.takesOff(copter, 8).fliesTo(copter, copter.place(30, 30), 12);
        lab.until("it is there", Duration.ofMinutes(1), () -> copter.distanceTo(copter.place(30, 30)) < 3);
        ann.does(copter, CommandRequests.land());
        return flight("ended");
    }

    @Test
    void aFlightIsRememberedAsItWasOnTheWire() {
        LinkFrameLog log = copter.wire().log();
        FlightView flight = fly();

        assertThat(flight.distance()).isBetween(35.0, 60.0);
        assertThat(flight.highest()).isBetween(10.0, 15.0);
        assertThat(flight.users()).containsExactly("ann");
        assertThat(flight.recordings()).hasSize(1);
        List<TelemetryPointView> points =
                telemetry().points(subject(flight), ALL).points();
        assertThat(points.size()).isGreaterThan((int) flight.seconds());
        points.forEach(
                point -> assertThat(metersOff(log, point)).as("%s", point).isLessThan(METERS));
        List<DroneEventView> events = lab.until(
                "its end is told",
                Duration.ofSeconds(10),
                () -> Optional.of(telemetry().events(subject(flight), ALL).events())
                        .filter(told ->
                                told.stream().anyMatch(event -> event.kind().equals("disarmed"))));
        assertThat(events).filteredOn(event -> event.kind().equals("command")).anySatisfy(event -> {
            assertThat(event.text()).isEqualTo("take off to 8 m");
            assertThat(event.result()).isEqualTo("succeeded");
        });
        assertThat(events).extracting(DroneEventView::kind).contains("armed", "disarmed", "mode");
        double highest = points.stream()
                .mapToDouble(point -> Objects.requireNonNull(point.altitudeAboveHome()))
                .max()
                .orElseThrow();
        TelemetrySearchRequest heights = new TelemetrySearchRequest(null, null, "altitudeAboveHome", "7", null);
        assertThat(Collections.max(telemetry()
                        .series(subject(flight), heights)
                        .fields()
                        .get(0)
                        .most()))
                .isCloseTo(highest, within(0.01));
    }

    /** From the nearest place that it said it was at around that time. */
    private double metersOff(LinkFrameLog log, TelemetryPointView point) {
        Geodetic here =
                new Geodetic(Objects.requireNonNull(point.latitude()), Objects.requireNonNull(point.longitude()));
        double height = Objects.requireNonNull(point.altitudeAboveHome());
        return log.frames(true).stream()
                .filter(passed -> passed.frame().messageId() == GlobalPositionInt.ID)
                .filter(passed -> Duration.between(began.plusNanos(passed.nanos()), point.at())
                                .abs()
                                .compareTo(IN_TIME)
                        <= 0)
                .map(passed -> GlobalPositionInt.decode(passed.frame()))
                .mapToDouble(said -> Math.hypot(
                        Geodesy.distanceMeters(here, new Geodetic(said.lat() / 1e7, said.lon() / 1e7)),
                        height - said.relativeAlt() / 1e3))
                .min()
                .orElse(Double.MAX_VALUE);
    }

    @Test
    void theFilesOfAFlightHoldAllOfItsPoints() throws IOException {
        FlightView flight = fly();
        int points = telemetry()
                .points(subject(flight), new TelemetrySearchRequest(null, null, null, null, "20000"))
                .points()
                .size();

        List<String> rows = file(flight, "csv").lines().skip(1).toList();
        assertThat(rows).hasSize(points);
        assertThat(count(file(flight, "gpx"), "<trkpt ")).isEqualTo(points);
        assertThat(count(file(flight, "kml"), "<gx:coord>")).isEqualTo(points);
        assertThat(file(flight, "geojson")).contains("\"LineString\"");
        StringWriter logbook = new StringWriter();
        lab.server().office().flights().logbook(ann.principal(), ANY, logbook);
        assertThat(logbook.toString()).contains(flight.id());
    }

    private String file(FlightView flight, String form) throws IOException {
        return Files.readString(
                lab.server().office().files().export(subject(flight), ALL, form).file());
    }

    private static int count(String text, String piece) {
        return text.split(piece, -1).length - 1;
    }

    @Test
    void aFlightGoesOnOverACrashAndLosesASecondAtMost() {
        ann.takesOff(copter, 8);
        FlightView before = flight("running");
        lab.until("telemetry is kept", Duration.ofSeconds(10), () -> keptUntil() != null);
        // As a crash at any of these moments would show.
        lab.throughout(
                "what is kept is not far behind",
                Duration.ofSeconds(10),
                () -> !shown().minus(MOST_LOST).isAfter(Objects.requireNonNull(keptUntil())));
        Instant shown = shown();

        lab.crashServer();
        lab.goOn(Duration.ofSeconds(3));
        lab.startServer();

        List<Instant> kept = kept();
        assertThat(kept.get(kept.size() - 1)).isBetween(shown.minus(MOST_LOST), shown);
        lab.until(
                "it is heard again",
                Duration.ofSeconds(10),
                () -> flights().get(0).state().equals("running"));
        ann.does(copter, CommandRequests.land());
        FlightView after = flight("ended");
        assertThat(copter.isDown()).isTrue();
        assertThat(after.id()).isEqualTo(before.id());
        assertThat(after.start()).isEqualTo(before.start());
        assertThat(flights()).hasSize(1);
    }

    private Instant shown() {
        return copter.state().lastUpdate();
    }

    private @Nullable Instant keptUntil() {
        List<Instant> kept = kept();
        return kept.isEmpty() ? null : kept.get(kept.size() - 1);
    }

    private List<Instant> kept() {
        String from = lab.now().minusSeconds(30).toString();
        TelemetryService.Subject subject =
                telemetry().drone(ann.principal(), copter.id().value());
        return telemetry().points(subject, new TelemetrySearchRequest(from, null, null, null, null)).points().stream()
                .map(TelemetryPointView::at)
                .toList();
    }
}
