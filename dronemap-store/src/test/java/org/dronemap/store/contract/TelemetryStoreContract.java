package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.SeriesBuilder;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.SeriesSlot;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link TelemetryStore} keeps to. */
public abstract class TelemetryStoreContract {
    protected static final DroneId DRONE = new DroneId("copter-1");
    protected static final Instant START = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneId OTHER = new DroneId("plane-2");
    private static final Retention FOR_EVER = new Retention(0, 0, Duration.ofSeconds(10));

    private TelemetryStore store;

    /** An empty store. */
    protected abstract TelemetryStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
        store.tidy(FOR_EVER, START);
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(points(DRONE)).isEmpty();
        assertThat(store.events(DRONE, all(), 10)).isEmpty();
        assertThat(store.series(new SeriesQuery(DRONE, all(), List.of(TelemetryField.ROLL), 10)))
                .isEmpty();
    }

    @Test
    void saysWhatItIs() {
        // Stands in the table that ends a test run.
        System.out.println("tried on: " + getClass().getSimpleName() + ", " + store.server());

        assertThat(store.server()).isNotBlank();
    }

    @Test
    void givesBackAllFacts() {
        TelemetryPoint full = new TelemetryPoint(
                DRONE,
                START,
                new Position(new Geodetic(47.397742123456, 8.545593654321), 488.25, 20.5),
                new Motion(5.5, 6.25, -0.75, 359.5),
                new Attitude(-3.5, 12.25, 180),
                new Battery(87, 12.587, 14.3),
                new Gps(GpsFix.RTK_FLOAT, 17, 0.71),
                LinkState.SUSPECT,
                new LinkQuality(0.0312, 0.01, 83.7, null, 12.5, 9.25),
                "GUIDED “Zürich” 🚁",
                true,
                FlightPhase.IN_AIR,
                4);

        store.append(List.of(full), List.of());

        assertThat(points(DRONE)).containsExactly(full);
    }

    @Test
    void givesBackNothingForWhatWasNotKnown() {
        TelemetryPoint empty = new TelemetryPoint(
                DRONE,
                START,
                null,
                null,
                null,
                null,
                null,
                LinkState.LIVE,
                LinkQuality.UNKNOWN,
                null,
                null,
                null,
                null);

        store.append(List.of(empty), List.of());

        assertThat(points(DRONE)).containsExactly(empty);
    }

    @Test
    void keepsAHeightWithoutAPlace() {
        TelemetryPoint high = at(0, new Position(null, null, 12.5), null);

        store.append(List.of(high), List.of());

        assertThat(points(DRONE)).containsExactly(high);
    }

    @Test
    void givesPointsOfOneDroneInOrderWithinTheSpan() {
        store.append(List.of(height(DRONE, 3, 3), height(OTHER, 1, 9), height(DRONE, 1, 1)), List.of());
        store.append(List.of(height(DRONE, 2, 2), height(DRONE, 0, 0)), List.of());

        assertThat(heights(new TimeRange(START.plusSeconds(1), START.plusSeconds(3))))
                .containsExactly(1.0, 2.0);
    }

    @Test
    void givesEachMomentOnceThoughItWasWrittenAgain() {
        store.append(List.of(height(DRONE, 1, 1), height(DRONE, 2, 2)), List.of());
        store.append(List.of(height(DRONE, 1, 1), height(DRONE, 2, 2)), List.of());

        assertThat(heights(all())).containsExactly(1.0, 2.0);
    }

    @Test
    void cutsTimesToMicroseconds() {
        store.append(List.of(height(DRONE, 0, 1, 999)), List.of());

        assertThat(points(DRONE)).extracting(TelemetryPoint::at).containsExactly(START);
    }

    @Test
    void keepsPointsOfDaysThatNobodyExpected() {
        store.append(
                List.of(height(DRONE, 0, 1), height(DRONE, 40 * 86_400L, 2), height(DRONE, -86_400L, 0)), List.of());
        store.tidy(FOR_EVER, START.plus(Duration.ofDays(1)));

        assertThat(heights(all())).containsExactly(0.0, 1.0, 2.0);
    }

    @Test
    void keepsManyPoints() {
        List<TelemetryPoint> many = IntStream.range(0, 25_000)
                .mapToObj(i -> at(i, new Position(new Geodetic(47 + i * 1e-6, 8), null, (double) i), null))
                .toList();

        store.append(many, List.of());

        assertThat(points(DRONE)).isEqualTo(many);
    }

    @Test
    void losesNoPeakInASeries() {
        List<TelemetryPoint> flight = flight();
        store.append(flight, List.of());
        SeriesQuery query = new SeriesQuery(
                DRONE,
                new TimeRange(START.plusSeconds(10), START.plusSeconds(900)),
                List.of(TelemetryField.ALTITUDE_ABOVE_HOME, TelemetryField.BATTERY_PERCENT, TelemetryField.HDOP),
                37);

        List<SeriesSlot> slots = store.series(query);

        SeriesBuilder judge = new SeriesBuilder(query);
        flight.stream().filter(point -> query.span().contains(point.at())).forEach(judge::add);
        assertThat(slots).isEqualTo(judge.slots()).hasSize(37);
        assertThat(slots)
                .extracting(slot -> slot.extents().get(0))
                .contains(new SeriesSlot.Extent(1, 500), new SeriesSlot.Extent(-77, 1));
        assertThat(slots).extracting(slot -> slot.extents().get(2)).containsOnlyNulls();
    }

    @Test
    void givesSinglePointsWhereSlotsAreFinerThanWhatIsKept() {
        store.append(List.of(height(DRONE, 0, 1), height(DRONE, 5, 2)), List.of());

        List<SeriesSlot> slots = store.series(new SeriesQuery(
                DRONE,
                new TimeRange(START, START.plusSeconds(10)),
                List.of(TelemetryField.ALTITUDE_ABOVE_HOME),
                1_000));

        assertThat(slots)
                .containsExactly(
                        new SeriesSlot(START, List.of(new SeriesSlot.Extent(1, 1))),
                        new SeriesSlot(START.plusSeconds(5), List.of(new SeriesSlot.Extent(2, 2))));
    }

    @Test
    void givesBackEventsInOrder() {
        HistoryEvent message = new HistoryEvent(
                DRONE,
                START,
                HistoryEvent.Kind.MESSAGE,
                "PreArm: \\N, \"quoted\"\nand 🚁",
                Severity.CRITICAL,
                null,
                null,
                null,
                null);
        HistoryEvent command = new HistoryEvent(
                DRONE,
                START,
                HistoryEvent.Kind.COMMAND,
                "take off to 20 m",
                null,
                "alice",
                "c-1",
                "refused",
                "Arm first.");
        HistoryEvent armed = HistoryEvent.of(DRONE, START.minusSeconds(1), HistoryEvent.Kind.ARMED, "Armed.");
        HistoryEvent others = HistoryEvent.of(OTHER, START, HistoryEvent.Kind.MODE, "AUTO");

        store.append(List.of(), List.of(message, command, others));
        store.append(List.of(), List.of(armed));

        assertThat(store.events(DRONE, all(), 10)).containsExactly(armed, message, command);
        assertThat(store.events(DRONE, all(), 2)).containsExactly(armed, message);
        assertThat(store.events(DRONE, new TimeRange(START.minusSeconds(9), START), 10))
                .containsExactly(armed);
    }

    @Test
    void dropsOldDaysAltogether() {
        store.append(
                List.of(height(DRONE, -3 * 86_400L, 1), height(DRONE, -2 * 86_400L, 2), height(DRONE, 0, 3)),
                List.of(
                        HistoryEvent.of(DRONE, START.minusSeconds(3 * 86_400L), HistoryEvent.Kind.MODE, "OLD"),
                        HistoryEvent.of(DRONE, START, HistoryEvent.Kind.MODE, "NEW")));
        store.tidy(FOR_EVER, START);

        store.tidy(new Retention(0, 2, Duration.ofSeconds(10)), START);

        assertThat(heights(all())).containsExactly(2.0, 3.0);
        assertThat(store.events(DRONE, all(), 10))
                .extracting(HistoryEvent::text)
                .containsExactly("NEW");
    }

    @Test
    void thinsOldDaysAndKeepsTheirPeaks() {
        List<TelemetryPoint> flight = flight();
        store.append(flight, List.of());
        Retention retention = new Retention(1, 30, Duration.ofSeconds(10));

        store.tidy(retention, START);
        assertThat(heights(all())).hasSize(flight.size());
        store.tidy(retention, START.plus(Duration.ofDays(2)));
        List<Double> thinned = heights(all());
        store.tidy(retention, START.plus(Duration.ofDays(3)));

        assertThat(thinned).hasSizeLessThan(flight.size() / 3).contains(500.0, -77.0, 0.0);
        assertThat(heights(all())).isEqualTo(thinned);
    }

    /** A quarter of an hour with one point a second, level but for two peaks of a moment. */
    private static List<TelemetryPoint> flight() {
        return IntStream.range(0, 900)
                .mapToObj(second -> at(
                        second,
                        new Position(new Geodetic(47, 8), null, height(second)),
                        new Battery(100 - second / 60, null, null)))
                .toList();
    }

    private static double height(int second) {
        if (second == 123) {
            return 500;
        }
        return second == 456 ? -77 : second == 0 ? 0 : 1;
    }

    private List<TelemetryPoint> points(DroneId drone) {
        List<TelemetryPoint> found = new ArrayList<>();
        store.points(drone, all(), found::add);
        return found;
    }

    private List<Double> heights(TimeRange span) {
        List<Double> found = new ArrayList<>();
        store.points(DRONE, span, point -> found.add(TelemetryField.ALTITUDE_ABOVE_HOME.of(point)));
        return found;
    }

    private static TimeRange all() {
        return new TimeRange(START.minus(Duration.ofDays(100)), START.plus(Duration.ofDays(100)));
    }

    private static TelemetryPoint height(DroneId drone, long second, double meters) {
        return height(drone, second, meters, 0);
    }

    private static TelemetryPoint height(DroneId drone, long second, double meters, int nanos) {
        return point(
                drone,
                START.plusSeconds(second).plusNanos(nanos),
                new Position(new Geodetic(47, 8), null, meters),
                null);
    }

    private static TelemetryPoint at(long second, Position position, @Nullable Battery battery) {
        return point(DRONE, START.plusSeconds(second), position, battery);
    }

    private static TelemetryPoint point(DroneId drone, Instant at, Position position, @Nullable Battery battery) {
        return new TelemetryPoint(
                drone,
                at,
                position,
                null,
                null,
                battery,
                null,
                LinkState.LIVE,
                LinkQuality.UNKNOWN,
                null,
                null,
                null,
                null);
    }
}
