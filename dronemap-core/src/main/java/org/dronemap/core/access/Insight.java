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
 * The past of a drone, which may have been others', as far as it is shown to somebody.
 *
 * @param stretches in any order; they may overlap
 */
public record Insight(List<Stretch> stretches) {
    /** It was never others'. */
    public static final Insight WHOLE = new Insight(List.of(new Stretch(Instant.MIN, Instant.MAX, true)));

    /** Nothing at all. */
    public static final Insight NONE = new Insight(List.of());

    /**
     * Some time.
     *
     * @param until not in it any more
     * @param named whether people are named who had to do with it
     */
    public record Stretch(Instant from, Instant until, boolean named) {
        boolean contains(Instant at) {
            return !at.isBefore(from) && at.isBefore(until);
        }

        private Stretch nameless() {
            return new Stretch(from, until, false);
        }
    }

    public Insight {
        stretches = List.copyOf(stretches);
    }

    /** By all that had a drone ever, the gifts in the order of time: at least one, the first from its first owner. */
    static Map<OrganisationId, Insight> after(List<Gift> gifts) {
        Map<OrganisationId, List<Stretch>> all = new HashMap<>();
        Instant since = Instant.MIN;
        for (Gift gift : gifts) {
            List<Stretch> giver = all.computeIfAbsent(gift.from(), id -> new ArrayList<>());
            giver.add(new Stretch(since, gift.at(), true));
            if (gift.histories()) {
                List<Stretch> along = giver.stream().map(Stretch::nameless).toList();
                all.computeIfAbsent(gift.to(), id -> new ArrayList<>()).addAll(along);
            }
            since = gift.at();
        }
        OrganisationId owner = gifts.get(gifts.size() - 1).to();
        all.computeIfAbsent(owner, id -> new ArrayList<>()).add(new Stretch(since, Instant.MAX, true));
        Map<OrganisationId, Insight> insights = new HashMap<>();
        all.forEach((id, stretches) -> insights.put(id, new Insight(stretches)));
        return insights;
    }

    public Sight at(Instant at) {
        Sight sight = Sight.NONE;
        for (Stretch each : stretches) {
            if (each.contains(at)) {
                if (each.named()) {
                    return Sight.ALL;
                }
                sight = Sight.WITHOUT_NAMES;
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
    public Optional<Stretch> within(Instant from, Instant until) {
        return stretches.stream()
                .filter(each -> each.from().isBefore(until) && each.until().isAfter(from))
                .map(each -> each.until().isBefore(until) ? each.until() : until)
                .max(Comparator.naturalOrder())
                .map(end -> {
                    Instant start = Objects.requireNonNull(backFrom(end.minusNanos(1)));
                    return new Stretch(start.isAfter(from) ? start : from, end, false);
                });
    }

    private @Nullable Instant startBefore(Instant moment) {
        return stretches.stream()
                .filter(each -> each.contains(moment))
                .map(Stretch::from)
                .min(Comparator.naturalOrder())
                .orElse(null);
    }
}
