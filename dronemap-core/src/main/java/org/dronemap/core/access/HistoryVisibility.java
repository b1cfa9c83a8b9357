package org.dronemap.core.access;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * The periods of a drone's history that a user may see, and whether with names of people.
 *
 * @param stretches in any order; they may overlap
 */
public record HistoryVisibility(List<Period> stretches) {
    /** It was never others'. */
    public static final HistoryVisibility WHOLE =
            new HistoryVisibility(List.of(new Period(Instant.MIN, Instant.MAX, true)));

    /** Nothing at all. */
    public static final HistoryVisibility NONE = new HistoryVisibility(List.of());

    /**
     * Some time.
     *
     * @param until not in it any more
     * @param named whether people are named who had to do with it
     */
    public record Period(Instant from, Instant until, boolean named) {
        boolean contains(Instant at) {
            return !at.isBefore(from) && at.isBefore(until);
        }

        private Period nameless() {
            return new Period(from, until, false);
        }
    }

    public HistoryVisibility {
        stretches = List.copyOf(stretches);
    }

    /** By all that had a drone ever, the gifts in the order of time: at least one, the first from its first owner. */
    static Map<OrganisationId, HistoryVisibility> after(List<Gift> gifts) {
        Map<OrganisationId, List<Period>> all = new HashMap<>();
        Instant since = Instant.MIN;
        for (Gift gift : gifts) {
            List<Period> giver = all.computeIfAbsent(gift.from(), id -> new ArrayList<>());
            giver.add(new Period(since, gift.at(), true));
            if (gift.histories()) {
                List<Period> along = giver.stream().map(Period::nameless).toList();
                all.computeIfAbsent(gift.to(), id -> new ArrayList<>()).addAll(along);
            }
            since = gift.at();
        }
        OrganisationId owner = gifts.get(gifts.size() - 1).to();
        all.computeIfAbsent(owner, id -> new ArrayList<>()).add(new Period(since, Instant.MAX, true));
        Map<OrganisationId, HistoryVisibility> insights = new HashMap<>();
        all.forEach((id, stretches) -> insights.put(id, new HistoryVisibility(stretches)));
        return insights;
    }

    public VisibilityLevel at(Instant at) {
        VisibilityLevel sight = VisibilityLevel.NONE;
        for (Period each : stretches) {
            if (each.contains(at)) {
                if (each.named()) {
                    return VisibilityLevel.ALL;
                }
                sight = VisibilityLevel.WITHOUT_NAMES;
            }
        }
        return sight;
    }

    /** Since when all is shown up to that moment, without a gap; null: that moment is not shown. */
    private @Nullable Instant backFrom(Instant moment) {
        Instant back = null;
        Instant next = startBefore(moment);
        while (next != null && !next.equals(back)) {
            back = next;
            next = next.equals(Instant.MIN) ? next : startBefore(next.minusNanos(1));
        }
        return back;
    }

    /** The last part of that time that is shown without a gap; empty: none is. */
    public Optional<Period> within(Instant from, Instant until) {
        return stretches.stream()
                .filter(each -> each.from().isBefore(until) && each.until().isAfter(from))
                .map(each -> each.until().isBefore(until) ? each.until() : until)
                .max(Comparator.naturalOrder())
                .map(end -> {
                    Instant start = Objects.requireNonNull(backFrom(end.minusNanos(1)));
                    return new Period(start.isAfter(from) ? start : from, end, false);
                });
    }

    private @Nullable Instant startBefore(Instant moment) {
        return stretches.stream()
                .filter(each -> each.contains(moment))
                .map(Period::from)
                .min(Comparator.naturalOrder())
                .orElse(null);
    }
}
