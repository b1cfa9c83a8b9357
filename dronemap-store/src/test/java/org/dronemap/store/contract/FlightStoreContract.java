package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.FlightQuery;
import org.dronemap.core.history.FlightStatistics;
import org.dronemap.core.history.FlightStore;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link FlightStore} keeps to. */
public abstract class FlightStoreContract {
    private static final Instant START = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneId DRONE = new DroneId("copter-1");
    private static final DroneId OTHER = new DroneId("plane-2");
    private static final FlightStatistics MEASURES = new FlightStatistics(
            1234.5, 99.25, 12.5, 600.0, 98, 42, new Geodetic(47.3977, 8.5456), new Geodetic(47.5, 8.6));

    private FlightStore store;

    /** An empty store. */
    protected abstract FlightStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.flights(FlightQuery.ALL, null, 10)).isEmpty();
        assertThat(store.flight("f1")).isEmpty();
        assertThat(store.open()).isEmpty();
    }

    @Test
    void givesBackOneThatGoesOn() {
        Flight flight = running("f1", DRONE, 0);
        store.save(flight);

        assertThat(store.flight("f1")).contains(flight);
        assertThat(store.open()).containsExactly(flight);
    }

    @Test
    void givesBackAllThatIsKnownOfOneThatEnded() {
        store.save(running("f1", DRONE, 0));
        Flight ended = new Flight(
                "f1",
                DRONE,
                "Copter “1”",
                START,
                START.plusSeconds(60),
                Flight.State.ENDED,
                START.plusSeconds(60),
                MEASURES,
                List.of("alice", "bob"),
                new Flight.FlightOperation("v1", "The virtual drone “Survey” of ann"),
                "There was no contact for a while.",
                "");
        store.save(ended);

        assertThat(store.flight("f1")).contains(ended);
        assertThat(store.open()).isEmpty();
    }

    @Test
    void keepsNotesWhileTheFlightGoesOn() {
        store.save(running("f1", DRONE, 0));

        assertThat(store.annotate("f1", "windy; 🚁")).isTrue();
        store.save(running("f1", DRONE, 0));

        assertThat(store.flight("f1")).map(Flight::notes).contains("windy; 🚁");
        assertThat(store.annotate("f2", "nobody's")).isFalse();
    }

    @Test
    void listsTheNewestFirstAndGoesOnFromThere() {
        store.save(running("b", DRONE, 0));
        store.save(running("c", DRONE, 5));
        store.save(running("a", OTHER, 0));
        store.save(running("d", OTHER, -5));

        List<Flight> first = store.flights(FlightQuery.ALL, null, 2);

        assertThat(first).extracting(Flight::id).containsExactly("c", "b");
        assertThat(store.flights(FlightQuery.ALL, first.get(1), 10))
                .extracting(Flight::id)
                .containsExactly("a", "d");
    }

    @Test
    void findsByDroneUserTimeAndWords() {
        store.save(running("f1", DRONE, 0));
        store.save(ended("f2", OTHER, 100, "alice"));
        store.annotate("f2", "Roof of the 100%_house");

        assertThat(found(new FlightQuery(OTHER, null, null, null, null))).containsExactly("f2");
        assertThat(found(new FlightQuery(null, "alice", null, null, null))).containsExactly("f2");
        assertThat(found(new FlightQuery(null, "ali", null, null, null))).isEmpty();
        assertThat(found(new FlightQuery(null, null, START.plusSeconds(1), null, null)))
                .containsExactly("f2");
        assertThat(found(new FlightQuery(null, null, START, START.plusSeconds(100), null)))
                .containsExactly("f1");
        assertThat(found(new FlightQuery(null, null, null, null, "roof of THE 100%_")))
                .containsExactly("f2");
        assertThat(found(new FlightQuery(null, null, null, null, "100__"))).isEmpty();
        assertThat(found(new FlightQuery(null, null, null, null, "COPTER-1"))).containsExactly("f1");
    }

    @Test
    void takesOnlyTheNewestOfADroneForOpen() {
        store.save(running("f1", DRONE, 0));
        store.save(running("f2", DRONE, 10));
        store.save(running("f3", OTHER, 5));

        assertThat(store.open()).extracting(Flight::id).containsExactlyInAnyOrder("f2", "f3");
    }

    @Test
    void cutsTimesToMicroseconds() {
        Flight fine = new Flight(
                "f1",
                DRONE,
                "c",
                START.plusNanos(999),
                START.plusNanos(1_999),
                Flight.State.ENDED,
                START.plusNanos(1_999),
                FlightStatistics.NONE,
                List.of(),
                null,
                null,
                "");
        store.save(fine);

        Flight kept = store.flight("f1").orElseThrow();
        assertThat(kept.start()).isEqualTo(START);
        assertThat(kept.end()).isEqualTo(START.plusNanos(1_000));
        assertThat(kept.lastHeardAt()).isEqualTo(START.plusNanos(1_000));
    }

    private List<String> found(FlightQuery query) {
        return store.flights(query, null, 10).stream().map(Flight::id).toList();
    }

    private static Flight running(String id, DroneId drone, long second) {
        return flight(id, drone, second, null, List.of());
    }

    private static Flight ended(String id, DroneId drone, long second, String user) {
        return flight(id, drone, second, START.plusSeconds(second + 60), List.of(user));
    }

    private static Flight flight(String id, DroneId drone, long second, @Nullable Instant end, List<String> users) {
        Instant start = START.plusSeconds(second);
        return new Flight(
                id,
                drone,
                drone.value(),
                start,
                end,
                end == null ? Flight.State.RUNNING : Flight.State.ENDED,
                start,
                FlightStatistics.NONE,
                users,
                null,
                null,
                "");
    }
}
