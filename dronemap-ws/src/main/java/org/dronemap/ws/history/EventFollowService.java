package org.dronemap.ws.history;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.LongFunction;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.EventSeries;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.jspecify.annotations.Nullable;

/**
 * Gives programs the events of all drones that they see, in the order of their numbers, and says where some are missing.
 * Any thread.
 */
final class EventFollowService {
    private final TelemetryStore store;
    private final EventWaiters waiters;

    EventFollowService(TelemetryStore store, EventWaiters waiters) {
        this.store = store;
        this.waiters = waiters;
    }

    /** {@code wait}: for so many seconds, when there is nothing to answer with. */
    CompletableFuture<FollowedEventsView> follow(
            AuthenticatedCaller caller, EventFollowRequest request, @Nullable Double wait) {
        Principal principal = caller.principal();
        RoleChecks.require(principal, Role.VIEWER);
        String place = request.place();
        EventCursor asked = place == null || place.equals(EventFollowRequest.FIRST) ? null : EventCursor.read(place);
        Duration longest = EventFollowRequest.longest(wait);
        @Nullable Set<DroneId> drones = request.chosen();
        int limit = request.most();
        long stamp = waiters.stamp();
        LongFunction<EventPage> pages = pages();
        EventSeries series = pages.apply(start(place, asked)).series();
        EventFollow follow = new EventFollow(caller, drones, limit, from(place, asked, series));
        if (place == null) {
            return CompletableFuture.completedFuture(follow.answer());
        }
        EventGapView missing = asked == null ? null : missing(asked, series);
        if (missing != null) {
            follow.begin(missing);
        }
        return follow.look(pages, () -> principal) || longest.isZero()
                ? CompletableFuture.completedFuture(follow.answer())
                : waiters.await(follow, longest, stamp);
    }

    /** Each asked for once. */
    private LongFunction<EventPage> pages() {
        Map<Long, EventPage> read = new HashMap<>();
        return number -> read.computeIfAbsent(number, after -> store.eventsAfter(after, EventFollow.PAGE));
    }

    private static long start(@Nullable String place, @Nullable EventCursor asked) {
        if (asked != null) {
            return asked.number();
        }
        return place == null ? Long.MAX_VALUE : 0;
    }

    private static EventCursor from(@Nullable String place, @Nullable EventCursor asked, EventSeries series) {
        if (asked != null) {
            return isOf(series, asked) ? asked : new EventCursor(series.id(), 0);
        }
        return new EventCursor(series.id(), place == null ? series.newest() : 0);
    }

    /** A number that was not given yet is one of a copy that went on otherwise. */
    private static boolean isOf(EventSeries series, EventCursor asked) {
        return series.id().equals(asked.series()) && asked.number() <= series.newest();
    }

    private static @Nullable EventGapView missing(EventCursor asked, EventSeries series) {
        if (!isOf(series, asked)) {
            return EventGapView.otherSeries();
        }
        return asked.number() < series.expired() ? EventGapView.expired(asked.number(), series) : null;
    }
}
