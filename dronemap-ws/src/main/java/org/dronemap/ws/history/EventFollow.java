package org.dronemap.ws.history;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.VisibilityLevel;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.EventEntry;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.NumberedEvent;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.jspecify.annotations.Nullable;

/**
 * One request for events: whose it is, how far it has looked, and what it has found. What is not for the caller is passed
 * over. Any thread.
 */
final class EventFollow {
    /** Of the store, at once. */
    static final int PAGE = 500;

    /** After so many pages without anything for the caller it is answered, so that it asks for more. */
    private static final int MOST_PAGES = 10;

    private final AuthenticatedCaller caller;
    private final @Nullable Set<DroneId> drones;
    private final int limit;
    private final String series;

    // Guarded by this.
    private long position;
    private int found;
    private final List<NumberedEventView> events = new ArrayList<>();
    private final List<EventGapView> gaps = new ArrayList<>();

    /**
     * @param drones null: all
     * @param limit of events and gaps, at least 1
     */
    EventFollow(AuthenticatedCaller caller, @Nullable Set<DroneId> drones, int limit, EventCursor from) {
        this.caller = caller;
        this.drones = drones;
        this.limit = limit;
        this.series = from.series();
        this.position = from.number();
    }

    AuthenticatedCaller caller() {
        return caller;
    }

    /** What is missing before all that is found. */
    synchronized void begin(EventGapView gap) {
        gaps.add(gap);
    }

    /**
     * Looks further; true when there is something to answer with. Not by two threads at once.
     *
     * @param pages of the store, after a number
     * @param asking who is shown what is there, as things are now
     */
    boolean look(LongFunction<EventPage> pages, Supplier<Principal> asking) {
        for (int i = 0; i < MOST_PAGES; i++) {
            EventPage page = pages.apply(position());
            if (!page.series().id().equals(series)) {
                // It is told so when it asks again.
                return true;
            }
            if (page.entries().stream().anyMatch(entry -> concerns(caller.principal(), entry))) {
                collect(page, asking.get());
            } else {
                pass(page);
            }
            if (isFull()) {
                return true;
            }
            if (!page.more()) {
                return hasFound();
            }
        }
        return true;
    }

    private synchronized long position() {
        return position;
    }

    private synchronized boolean hasFound() {
        return !events.isEmpty() || !gaps.isEmpty();
    }

    private synchronized void collect(EventPage page, Principal principal) {
        for (EventEntry entry : page.entries()) {
            if (concerns(principal, entry)) {
                add(principal, entry);
            }
            position = entry.number();
            if (isFull()) {
                return;
            }
        }
        pass(page);
    }

    private synchronized void pass(EventPage page) {
        position = page.next();
    }

    private boolean concerns(Principal principal, EventEntry entry) {
        return !(entry instanceof NumberedEvent numbered)
                || ((drones == null || drones.contains(numbered.event().drone()))
                        && sight(principal, numbered) != VisibilityLevel.NONE);
    }

    private static VisibilityLevel sight(Principal principal, NumberedEvent numbered) {
        return principal.sight(numbered.event().drone(), numbered.event().at());
    }

    private void add(Principal principal, EventEntry entry) {
        found++;
        if (entry instanceof NumberedEvent numbered) {
            boolean named = sight(principal, numbered) == VisibilityLevel.ALL;
            events.add(NumberedEventView.of(
                    numbered.number(), named ? numbered.event() : NameRedaction.event(numbered.event())));
        } else if (entry instanceof EventGap gap) {
            gaps.add(EventGapView.of(
                    gap, principal.isWhole() && principal.organisation().isHome()));
        }
    }

    private synchronized boolean isFull() {
        return found >= limit;
    }

    /** What was found up to now. */
    synchronized FollowedEventsView answer() {
        return new FollowedEventsView(
                List.copyOf(events), List.copyOf(gaps), new EventCursor(series, position).written());
    }
}
