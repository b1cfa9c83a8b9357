package org.dronemap.ws.history;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.store.memory.MemoryTelemetryStore;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Events that are followed from a store in memory, in stepped time. */
class EventFollowServiceTest {
    private static final Instant START = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final Instant MIDNIGHT = Instant.parse("2026-03-04T00:00:00Z");
    private static final DroneId DRONE = new DroneId("copter-1");
    private static final DroneId OTHER = new DroneId("plane-2");
    private static final AuthenticatedCaller ANN = caller(new Principal("ann", Role.VIEWER));
    /** Sees the one drone only. */
    private static final AuthenticatedCaller KEY = caller(new Principal(
            "ann",
            Role.VIEWER,
            new KeyScope(Set.of(DRONE), Set.of(Permission.VIEW)),
            "k",
            new NamelessHistory(),
            "ann"));

    private static final double LONG = 30;

    private final SteppedTime time = new SteppedTime(START);
    private int reads;
    private final TelemetryStore memory = new MemoryTelemetryStore();
    private final TelemetryStore store = (TelemetryStore) Proxy.newProxyInstance(
            getClass().getClassLoader(), new Class<?>[] {TelemetryStore.class}, (proxy, method, arguments) -> {
                if (method.getName().equals("eventsAfter")) {
                    reads++;
                }
                return method.invoke(memory, arguments);
            });
    private @Nullable Rejection turnedAway;
    private final EventWaiters waiters = new EventWaiters(store, this::judged, time);
    private final EventFollowService events = new EventFollowService(store, waiters);

    private Principal judged(EventFollow follow) {
        if (turnedAway != null) {
            throw turnedAway;
        }
        return follow.caller().principal();
    }

    @BeforeEach
    void start() {
        waiters.start();
        time.advance(Duration.ZERO);
    }

    @Test
    void answersWhoWaitsAsSoonAsSomethingIsStored() {
        CompletableFuture<FollowedEventsView> waiting = follow(ANN, fromNowOn(), LONG);
        assertThat(waiting).isNotDone();

        stored(event(DRONE, 1, "a"));

        assertThat(waiting).isCompleted();
        assertThat(texts(waiting)).containsExactly("a");
        assertThat(time.clock().instant()).isEqualTo(START);
        assertThat(waiters.count()).isZero();
    }

    @Test
    void answersWithWhatWasStoredWhileItLooked() {
        String from = fromNowOn();
        long stamp = waiters.stamp();
        stored(event(DRONE, 1, "a"));
        EventFollow follow = new EventFollow(ANN, null, 10, EventCursor.read(from));

        CompletableFuture<FollowedEventsView> waiting = waiters.await(follow, Duration.ofSeconds(30), stamp);
        time.advance(Duration.ZERO);

        assertThat(texts(waiting)).containsExactly("a");
    }

    @Test
    void answersWithoutEventsWhenTheWaitIsOver() {
        String from = fromNowOn();
        CompletableFuture<FollowedEventsView> waiting = follow(ANN, from, 5.0);

        time.advance(Duration.ofMillis(4_999));
        assertThat(waiting).isNotDone();
        time.advance(Duration.ofMillis(1));

        assertThat(texts(waiting)).isEmpty();
        assertThat(done(waiting).next()).isEqualTo(from);
        assertThat(waiters.count()).isZero();
    }

    @Test
    void waitsOnWhileThereIsOnlyWhatTheCallerDoesNotSee() {
        String from = fromNowOn();
        CompletableFuture<FollowedEventsView> waiting = follow(KEY, from, 5.0);

        stored(event(OTHER, 1, "hidden"));
        assertThat(waiting).isNotDone();
        time.advance(Duration.ofSeconds(5));

        assertThat(texts(waiting)).isEmpty();
        assertThat(done(waiting).next()).isNotEqualTo(from);
        assertThat(done(waiting).next()).isEqualTo(fromNowOn());
    }

    @Test
    void turnsAwayWhoMayLookNoLonger() {
        CompletableFuture<FollowedEventsView> waiting = follow(ANN, fromNowOn(), LONG);
        turnedAway = Rejection.sessionEnded();

        stored(event(DRONE, 1, "a"));

        assertThat(waiting).isCompletedExceptionally();
        assertThat(waiters.count()).isZero();
    }

    @Test
    void readsOnceForAllWhoWait() {
        String from = fromNowOn();
        List<CompletableFuture<FollowedEventsView>> all =
                IntStream.range(0, 40).mapToObj(i -> follow(ANN, from, LONG)).toList();
        reads = 0;

        stored(event(DRONE, 1, "a"));

        assertThat(all).allSatisfy(waiting -> assertThat(texts(waiting)).containsExactly("a"));
        assertThat(reads).isEqualTo(1);
    }

    @Test
    void boundsHowManyWait() {
        String from = fromNowOn();
        List<CompletableFuture<FollowedEventsView>> all = new ArrayList<>();
        for (int i = 0; i < EventWaiters.MOST; i++) {
            all.add(follow(caller(new Principal("user-" + i / EventWaiters.MOST_OF_ONE, Role.VIEWER)), from, LONG));
        }

        assertThatThrownBy(() -> follow(caller(new Principal("user-0", Role.VIEWER)), from, LONG))
                .isInstanceOfSatisfying(
                        Rejection.class, why -> assertThat(why.code()).isEqualTo(ServerProblem.WAITS_SPENT))
                .hasMessageContaining("50");
        assertThatThrownBy(() -> follow(ANN, from, LONG))
                .isInstanceOfSatisfying(
                        Rejection.class, why -> assertThat(why.code()).isEqualTo(ServerProblem.SERVER_BUSY));
        assertThat(follow(ANN, from, null)).isCompleted();
        time.advance(Duration.ofSeconds(30));
        assertThat(all).allMatch(CompletableFuture::isDone);
        assertThat(follow(ANN, from, LONG)).isNotDone();
    }

    @Test
    void answersAllWhoWaitWhenTheServerStops() {
        CompletableFuture<FollowedEventsView> waiting = follow(ANN, fromNowOn(), LONG);

        waiters.stop();

        assertThat(texts(waiting)).isEmpty();
        assertThat(follow(ANN, fromNowOn(), LONG)).isCompleted();
    }

    @Test
    void beginsWithTheOldestThatIsKeptAndStopsAtTheLimit() {
        stored(event(DRONE, 1, "a"), event(OTHER, 2, "b"), event(DRONE, 3, "c"));

        FollowedEventsView first = done(follow(ANN, "first", 2, null));
        FollowedEventsView second = done(follow(ANN, first.next(), 2, null));

        assertThat(texts(first)).containsExactly("a", "b");
        assertThat(texts(second)).containsExactly("c");
        assertThat(first.gaps()).isEmpty();
    }

    @Test
    void looksAtABoundedPartAndGoesOnAfterIt() {
        IntStream.range(0, 6_000).forEach(i -> memory.append(List.of(), List.of(event(OTHER, i, "hidden"))));
        memory.append(List.of(), List.of(event(DRONE, 1, "shown")));
        reads = 0;

        CompletableFuture<FollowedEventsView> first = follow(KEY, "first", LONG);

        assertThat(texts(first)).isEmpty();
        assertThat(reads).isLessThanOrEqualTo(10);
        assertThat(texts(follow(KEY, first.join().next(), LONG))).containsExactly("shown");
    }

    @Test
    void tellsWhatWasDroppedOverItsTime() {
        Instant old = MIDNIGHT.minus(Duration.ofDays(3));
        stored(HistoryEvent.of(DRONE, old, HistoryEvent.Kind.MODE, "read"));
        FollowedEventsView before = done(follow(ANN, "first", null));
        stored(HistoryEvent.of(DRONE, old, HistoryEvent.Kind.MODE, "dropped"));
        stored(event(DRONE, 1, "kept"));
        memory.tidy(new Retention(0, 2, Duration.ofSeconds(10)), START);

        FollowedEventsView after = done(follow(ANN, before.next(), null));

        assertThat(texts(after)).containsExactly("kept");
        assertThat(after.gaps())
                .containsExactly(new EventGapView(
                        before.events().get(0).number(),
                        "expired",
                        null,
                        MIDNIGHT.minus(Duration.ofDays(2)),
                        null,
                        "The server has dropped events of this time, for they are no longer kept."));
        assertThat(done(follow(ANN, after.next(), null)).gaps()).isEmpty();
    }

    @Test
    void tellsNothingToWhomReadAllThatWasDropped() {
        stored(HistoryEvent.of(DRONE, MIDNIGHT.minus(Duration.ofDays(3)), HistoryEvent.Kind.MODE, "read"));
        FollowedEventsView before = done(follow(ANN, "first", null));
        memory.tidy(new Retention(0, 2, Duration.ofSeconds(10)), START);
        memory.openEvents(START);
        stored(event(DRONE, 1, "kept"));

        FollowedEventsView after = done(follow(ANN, before.next(), null));

        assertThat(texts(after)).containsExactly("kept");
        assertThat(after.gaps()).isEmpty();
    }

    @Test
    void tellsThatALossIsAGapAndHowManyToThoseWhoRunTheServer() {
        String from = fromNowOn();
        CompletableFuture<FollowedEventsView> waiting = follow(ANN, from, LONG);
        memory.append(List.of(), List.of(), new EventLoss(START, START.plusSeconds(5), 7));
        waiters.wake();
        time.advance(Duration.ZERO);

        assertThat(done(waiting).gaps()).singleElement().satisfies(gap -> {
            assertThat(gap.cause()).isEqualTo("notWritten");
            assertThat(gap.count()).isEqualTo(7);
            assertThat(gap.from()).isEqualTo(Instant.parse("2026-03-04T05:06:07.123Z"));
            assertThat(gap.until()).isEqualTo(Instant.parse("2026-03-04T05:06:12.123Z"));
        });
        assertThat(done(follow(KEY, from, null)).gaps())
                .singleElement()
                .satisfies(gap -> assertThat(gap.count()).isNull());
        assertThat(done(follow(ANN, done(waiting).next(), null)).gaps()).isEmpty();
    }

    @Test
    void tellsThatAPlaceIsOfAnotherSeries() {
        stored(event(DRONE, 1, "a"));

        FollowedEventsView answer = done(follow(ANN, new EventCursor("another", 1).written(), null));

        assertThat(texts(answer)).containsExactly("a");
        assertThat(answer.gaps()).extracting(EventGapView::cause).containsExactly("otherSeries");
        assertThat(done(follow(ANN, answer.next(), null)).gaps()).isEmpty();
    }

    @Test
    void tellsThatANumberWasNeverGivenHere() {
        stored(event(DRONE, 1, "a"));
        EventCursor now = EventCursor.read(fromNowOn());

        FollowedEventsView answer = done(follow(ANN, new EventCursor(now.series(), now.number() + 1).written(), LONG));

        assertThat(texts(answer)).containsExactly("a");
        assertThat(answer.gaps()).extracting(EventGapView::cause).containsExactly("otherSeries");
    }

    @Test
    void namesNobodyOfTheTimeWhenTheDroneWasOthers() {
        HistoryEvent command = new HistoryEvent(
                DRONE, START, HistoryEvent.Kind.COMMAND, "arm", null, "zoe", "c-1", "refused", "zoe said no");
        stored(command);

        NumberedEventView shown = done(follow(KEY, "first", null)).events().get(0);

        assertThat(shown.by()).isEqualTo(NameRedaction.OTHERS);
        assertThat(shown.reason()).isNull();
    }

    private String fromNowOn() {
        return done(follow(ANN, null, LONG)).next();
    }

    private CompletableFuture<FollowedEventsView> follow(
            AuthenticatedCaller who, @Nullable String after, @Nullable Double wait) {
        return follow(who, after, 100, wait);
    }

    private CompletableFuture<FollowedEventsView> follow(
            AuthenticatedCaller who, @Nullable String after, int limit, @Nullable Double wait) {
        return events.follow(who, new EventFollowRequest(after, limit, null), wait);
    }

    /** As the writer does it. */
    private void stored(HistoryEvent... happened) {
        memory.append(List.of(), List.of(happened));
        waiters.wake();
        time.advance(Duration.ZERO);
    }

    private static HistoryEvent event(DroneId drone, long second, String text) {
        return HistoryEvent.of(drone, START.plusSeconds(second), HistoryEvent.Kind.MODE, text);
    }

    private static AuthenticatedCaller caller(Principal principal) {
        return new AuthenticatedCaller(principal, AuthenticatedCaller.Proof.KEY, null, null, false);
    }

    private static FollowedEventsView done(CompletableFuture<FollowedEventsView> answer) {
        assertThat(answer).isCompleted();
        return answer.join();
    }

    private static List<String> texts(CompletableFuture<FollowedEventsView> answer) {
        return texts(done(answer));
    }

    private static List<String> texts(FollowedEventsView answer) {
        return answer.events().stream().map(NumberedEventView::text).toList();
    }
}
