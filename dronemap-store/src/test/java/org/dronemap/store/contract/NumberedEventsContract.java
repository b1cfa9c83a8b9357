package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.EventEntry;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.NumberedEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryStore;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link TelemetryStore} keeps to where it numbers events and tells gaps among them. */
public abstract class NumberedEventsContract {
    protected static final DroneId DRONE = new DroneId("copter-1");
    protected static final Instant START = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneId OTHER = new DroneId("plane-2");
    private static final Instant MIDNIGHT = Instant.parse("2026-03-04T00:00:00Z");
    private static final Retention TWO_DAYS = new Retention(0, 2, Duration.ofSeconds(10));
    private static final int MANY = 1_000;

    private TelemetryStore store;

    /** An empty store. */
    protected abstract TelemetryStore emptyStore();

    /** The same one, as a process that is started anew opens it. */
    protected abstract TelemetryStore again();

    @BeforeEach
    void open() {
        store = emptyStore();
        store.tidy(new Retention(0, 0, Duration.ofSeconds(10)), START);
    }

    @Test
    void isEmptyAtFirst() {
        EventPage page = store.eventsAfter(0, MANY);

        assertThat(page.entries()).isEmpty();
        assertThat(page.more()).isFalse();
        assertThat(page.next()).isZero();
        assertThat(page.series().id()).isNotBlank();
        assertThat(page.series().expired()).isZero();
        assertThat(page.series().expiredBefore()).isNull();
    }

    @Test
    void numbersEventsOfAllDronesInTheOrderInWhichTheyAreStored() {
        HistoryEvent full = new HistoryEvent(
                DRONE,
                START,
                HistoryEvent.Kind.COMMAND,
                "take off to 20 m",
                Severity.CRITICAL,
                "alice",
                "c-1",
                "refused",
                "Arm first.");
        HistoryEvent earlier = event(OTHER, -100, "earlier");
        HistoryEvent later = event(DRONE, 1, "later");

        store.append(List.of(), List.of(full, earlier));
        store.append(List.of(), List.of(later));

        EventPage page = store.eventsAfter(0, MANY);
        assertThat(page.entries())
                .extracting(entry -> ((NumberedEvent) entry).event())
                .containsExactly(full, earlier, later);
        assertThat(page.entries()).isSortedAccordingTo(Comparator.comparingLong(EventEntry::number));
        assertThat(numbers(page)).doesNotHaveDuplicates().allMatch(number -> number > 0 && number < 1L << 53);
        assertThat(page.series().newest()).isEqualTo(number(page, 2));
    }

    @Test
    void goesOnAfterANumber() {
        store.append(List.of(), List.of(event(DRONE, 0, "a"), event(DRONE, 1, "b"), event(DRONE, 2, "c")));
        EventPage all = store.eventsAfter(0, MANY);

        EventPage first = store.eventsAfter(0, 2);
        EventPage second = store.eventsAfter(first.next(), 2);
        EventPage third = store.eventsAfter(second.next(), 2);

        assertThat(texts(first)).containsExactly("a", "b");
        assertThat(first.more()).isTrue();
        assertThat(first.next()).isEqualTo(number(all, 1));
        assertThat(texts(second)).containsExactly("c");
        assertThat(second.more()).isFalse();
        assertThat(third.entries()).isEmpty();
        assertThat(third.next()).isEqualTo(number(all, 2));
    }

    @Test
    void tellsWhatWasLostBeforeTheEventsThatItComesWith() {
        store.append(List.of(), List.of(event(DRONE, 0, "before")));
        store.append(
                List.of(),
                List.of(event(DRONE, 9, "after")),
                new EventLoss(START.plusSeconds(2), START.plusSeconds(5), 7));

        EventPage page = store.eventsAfter(0, MANY);

        assertThat(page.entries()).hasSize(3);
        assertThat(page.entries().get(1))
                .isEqualTo(new EventGap(
                        number(page, 1), EventGap.Cause.NOT_WRITTEN, START.plusSeconds(2), START.plusSeconds(5), 7L));
        assertThat(texts(page)).containsExactly("before", null, "after");
        assertThat(numbers(page)).isSorted();
        assertThat(texts(store.eventsAfter(number(page, 0), 1))).containsExactly((String) null);
        assertThat(texts(store.eventsAfter(number(page, 1), 1))).containsExactly("after");
    }

    @Test
    void tellsALossWithoutEvents() {
        store.append(List.of(), List.of(), new EventLoss(START, START, 1));

        assertThat(store.eventsAfter(0, MANY).entries())
                .singleElement()
                .isInstanceOfSatisfying(
                        EventGap.class, gap -> assertThat(gap.lost()).isEqualTo(1));
    }

    @Test
    void knowsNothingOfAnEndThatWasClean() {
        store.openEvents(START);
        store.append(List.of(), List.of(event(DRONE, 1, "a")));
        store.closeEvents();

        store = again();
        store.openEvents(START.plusSeconds(60));
        store.append(List.of(), List.of(event(DRONE, 61, "b")));

        assertThat(texts(store.eventsAfter(0, MANY))).containsExactly("a", "b");
    }

    @Test
    void tellsThatAProcessEndedWithWhatItHadInMemory() {
        store.openEvents(START);
        store.append(List.of(), List.of(event(DRONE, 1, "a")));

        store = again();
        store.openEvents(START.plusSeconds(60));
        store.append(List.of(), List.of(event(DRONE, 61, "b")));

        EventPage page = store.eventsAfter(0, MANY);
        assertThat(texts(page)).containsExactly("a", null, "b");
        assertThat(page.entries().get(1))
                .isEqualTo(new EventGap(
                        number(page, 1),
                        EventGap.Cause.SERVER_ENDED,
                        START.plusSeconds(1),
                        START.plusSeconds(60),
                        null));
    }

    @Test
    void tellsTheWholeTimeOfAProcessThatStoredNothing() {
        store.openEvents(START);
        store = again();
        store.openEvents(START.plusSeconds(60));

        assertThat(store.eventsAfter(0, MANY).entries())
                .extracting(entry -> ((EventGap) entry).from(), EventEntry::at)
                .containsExactly(tuple(START, START.plusSeconds(60)));
    }

    @Test
    void goesOnRisingInTheSameSeriesOverStarts() {
        store.openEvents(START);
        store.append(List.of(), List.of(event(DRONE, 1, "a")));
        EventPage before = store.eventsAfter(0, MANY);
        store.closeEvents();

        // The clock was set back meanwhile.
        store = again();
        store.openEvents(START.minusSeconds(3_600));
        store.append(List.of(), List.of(event(DRONE, 2, "b")));

        EventPage after = store.eventsAfter(before.next(), MANY);
        assertThat(texts(after)).containsExactly("b");
        assertThat(after.series().id()).isEqualTo(before.series().id());
    }

    @Test
    void givesNoNumberThatACopyOfItMayHaveGivenBefore() {
        store.openEvents(START);

        store.append(List.of(), List.of(event(DRONE, 1, "a")));

        assertThat(number(store.eventsAfter(0, MANY), 0)).isGreaterThan(START.toEpochMilli() * 1_000);
    }

    @Test
    void tellsUpToWhichNumberEventsWereDroppedOverTheirTime() {
        Instant old = MIDNIGHT.minus(Duration.ofDays(2)).minusSeconds(1);
        store.append(List.of(), List.of(at(old.minusSeconds(60), "oldest"), at(old, "old")));
        store.append(List.of(), List.of(event(DRONE, 0, "new")));
        EventPage before = store.eventsAfter(0, MANY);

        store.tidy(TWO_DAYS, START);

        EventPage after = store.eventsAfter(0, MANY);
        assertThat(texts(after)).containsExactly("new");
        assertThat(after.series().expired()).isEqualTo(number(before, 1));
        assertThat(after.series().expiredBefore()).isEqualTo(MIDNIGHT.minus(Duration.ofDays(2)));
        assertThat(after.series().newest()).isEqualTo(number(before, 2));
    }

    @Test
    void droppedNothingThatIsStillThere() {
        store.append(List.of(), List.of(event(DRONE, 0, "new")));

        store.tidy(TWO_DAYS, START);
        store.tidy(TWO_DAYS, START.plusSeconds(3_600));

        assertThat(store.eventsAfter(0, MANY).series().expired()).isZero();
    }

    @Test
    void remembersTheNewestNumberThoughAllWasDropped() {
        store.append(List.of(), List.of(event(DRONE, 0, "a")), new EventLoss(START, START, 1));
        EventPage before = store.eventsAfter(0, MANY);

        store.tidy(TWO_DAYS, START.plus(Duration.ofDays(10)));

        EventPage after = store.eventsAfter(0, MANY);
        assertThat(after.entries()).isEmpty();
        assertThat(after.series().newest()).isEqualTo(before.series().newest());
        assertThat(after.series().expired()).isEqualTo(before.series().newest());
    }

    private static HistoryEvent event(DroneId drone, long second, String text) {
        return HistoryEvent.of(drone, START.plusSeconds(second), HistoryEvent.Kind.MODE, text);
    }

    private static HistoryEvent at(Instant at, String text) {
        return HistoryEvent.of(DRONE, at, HistoryEvent.Kind.MODE, text);
    }

    /** Null for a gap. */
    private static List<@Nullable String> texts(EventPage page) {
        return page.entries().stream()
                .<@Nullable String>map(entry ->
                        entry instanceof NumberedEvent event ? event.event().text() : null)
                .toList();
    }

    private static List<Long> numbers(EventPage page) {
        return page.entries().stream().map(EventEntry::number).toList();
    }

    private static long number(EventPage page, int place) {
        return page.entries().get(place).number();
    }
}
