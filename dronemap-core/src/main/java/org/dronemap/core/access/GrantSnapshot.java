package org.dronemap.core.access;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/** Immutable snapshot of a {@link GrantRegistry}, indexed for frequent lookups. */
final class GrantSnapshot {
    private static final int BITS_FOR_TURNS = 24;

    private final OrganisationDirectory holdings;
    private final Map<DroneId, OrganisationId> lent;
    private final long number;
    /** Of those only who see nothing but what was granted. */
    private final Map<String, List<ResolvedGrant>> held;
    /** Of each drone that was ever given away, in the order of time. */
    private final Map<DroneId, List<Gift>> gifts;

    private final Map<DroneId, Map<OrganisationId, HistoryVisibility>> insights = new HashMap<>();
    /** When grants begin and end, in order. */
    private final Instant[] turns;

    /** A grant, and the drones that it means; null: all of its organisation. */
    record ResolvedGrant(Grant grant, @Nullable Set<DroneId> drones) {
        boolean covers(DroneId drone) {
            return drones == null || drones.contains(drone);
        }
    }

    GrantSnapshot(OrganisationDirectory holdings, Map<DroneId, OrganisationId> lent, long number) {
        this.holdings = holdings;
        this.lent = lent;
        this.number = number;
        this.held = held(holdings);
        this.gifts = holdings.gifts().stream()
                .sorted(Comparator.comparing(Gift::at))
                .collect(Collectors.groupingBy(Gift::drone));
        gifts.forEach((drone, its) -> insights.put(drone, HistoryVisibility.after(its)));
        this.turns = holdings.grants().stream()
                .flatMap(grant -> Stream.concat(Stream.of(grant.from()), Stream.ofNullable(grant.until())))
                .sorted()
                .distinct()
                .toArray(Instant[]::new);
    }

    OrganisationDirectory holdings() {
        return holdings;
    }

    Map<DroneId, OrganisationId> lent() {
        return lent;
    }

    long number() {
        return number;
    }

    long edition(Instant now) {
        int at = Arrays.binarySearch(turns, now);
        int passed = at >= 0 ? at + 1 : -at - 1;
        return (number << BITS_FOR_TURNS) + passed;
    }

    OrganisationId owner(DroneId drone) {
        OrganisationId owner = lent.get(drone);
        return owner == null ? holdings.owners().getOrDefault(drone, OrganisationId.HOME) : owner;
    }

    /** What is shown of a drone's past to an organisation. */
    HistoryVisibility insight(OrganisationId organisation, DroneId drone) {
        Map<OrganisationId, HistoryVisibility> known = insights.get(drone);
        if (known == null || lent.containsKey(drone)) {
            return owner(drone).equals(organisation) ? HistoryVisibility.WHOLE : HistoryVisibility.NONE;
        }
        return known.getOrDefault(organisation, HistoryVisibility.NONE);
    }

    Optional<Gift> lastGift(DroneId drone) {
        List<Gift> known = gifts.get(drone);
        return known == null ? Optional.empty() : Optional.of(known.get(known.size() - 1));
    }

    boolean isOnlyGranted(String user) {
        return held.containsKey(user);
    }

    /** Null: that user sees by the role alone. */
    @Nullable
    List<ResolvedGrant> held(String user) {
        return held.get(user);
    }

    /** Of all that is in force now; {@code drone} null: with any. */
    static Set<Permission> permissions(List<ResolvedGrant> held, @Nullable DroneId drone, Instant now) {
        EnumSet<Permission> all = drone == null ? EnumSet.of(Permission.VIEW) : EnumSet.noneOf(Permission.class);
        for (ResolvedGrant each : held) {
            if (each.grant().isInForce(now) && (drone == null || each.covers(drone))) {
                all.addAll(each.grant().permissions());
            }
        }
        return all;
    }

    /** With virtual drones, which any drone of the organisation may serve. */
    static Set<Permission> virtually(List<ResolvedGrant> held, Instant now) {
        EnumSet<Permission> all = EnumSet.noneOf(Permission.class);
        for (ResolvedGrant each : held) {
            GrantObject object = each.grant().object();
            boolean virtual = object instanceof GrantObject.Virtual || object instanceof GrantObject.Everything;
            if (virtual && each.grant().isInForce(now)) {
                all.addAll(each.grant().permissions());
            }
        }
        return all;
    }

    private static Map<String, List<ResolvedGrant>> held(OrganisationDirectory holdings) {
        Map<String, Set<String>> members =
                holdings.groups().stream().collect(Collectors.toMap(UserGroup::id, UserGroup::members));
        Map<String, Set<DroneId>> fleets =
                holdings.fleets().stream().collect(Collectors.toMap(Fleet::id, Fleet::drones));
        Map<String, List<ResolvedGrant>> held = new HashMap<>();
        for (GrantSubject subject : holdings.onlyGranted()) {
            users(subject, members).forEach(user -> held.put(user, new ArrayList<>()));
        }
        for (Grant grant : holdings.grants()) {
            ResolvedGrant each = new ResolvedGrant(grant, drones(grant.object(), fleets));
            for (String user : users(grant.subject(), members)) {
                List<ResolvedGrant> all = held.get(user);
                if (all != null) {
                    all.add(each);
                }
            }
        }
        return held;
    }

    private static Set<String> users(GrantSubject subject, Map<String, Set<String>> members) {
        if (subject instanceof GrantSubject.OfUser user) {
            return Set.of(user.name());
        }
        return members.getOrDefault(((GrantSubject.OfGroup) subject).id(), Set.of());
    }

    private static @Nullable Set<DroneId> drones(GrantObject object, Map<String, Set<DroneId>> fleets) {
        if (object instanceof GrantObject.Everything) {
            return null;
        }
        if (object instanceof GrantObject.Virtual) {
            return Set.of();
        }
        return object instanceof GrantObject.Drones drones
                ? drones.ids()
                : fleets.getOrDefault(((GrantObject.OfFleet) object).id(), Set.of());
    }
}
