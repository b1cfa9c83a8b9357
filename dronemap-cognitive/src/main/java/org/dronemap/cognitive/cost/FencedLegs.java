package org.dronemap.cognitive.cost;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Costs of legs that lead round barriers, each found when it is first asked for and then cached. Of a problem that is
 * not too big all are kept; of a bigger one as many as there is room for. Safe for several threads: two may find the
 * same way at once, and find the same.
 */
final class FencedLegs implements Legs, Detours {
    /** So many ways are kept at most, of all groups of drones together; a power of two. */
    private static final int KEPT = 1 << 21;

    /** Whatever its ends. */
    private static final Detour STRAIGHT = new Detour(-1, -1, List.of(), null);

    private final DirectLegs open;
    private final int places;
    private final boolean all;
    private final int room;
    private final DetourFinder[] guides;
    /** Of each type; types in the same surroundings share one. */
    private final AtomicReferenceArray<Detour>[] kept;

    @SuppressWarnings({"unchecked", "rawtypes"})
    FencedLegs(PlaceTable track, DirectLegs open, FlightModel[] paces, List<BarrierMap> surroundings) {
        this.open = open;
        this.places = track.places;
        this.guides = new DetourFinder[paces.length];
        this.kept = new AtomicReferenceArray[paces.length];
        IdentityHashMap<BarrierMap, Integer> known = new IdentityHashMap<>();
        int groups = (int) surroundings.stream().distinct().count();
        this.room = Integer.highestOneBit(KEPT / groups);
        this.all = (long) places * places <= room;
        int size = all ? places * places : room;
        for (int type = 0; type < paces.length; type++) {
            Integer same = known.putIfAbsent(surroundings.get(type), type);
            guides[type] = same == null ? new DetourFinder(track, paces, surroundings.get(type)) : guides[same];
            kept[type] = same == null ? new AtomicReferenceArray<>(size) : kept[same];
        }
    }

    private Detour find(int type, int from, int to) {
        AtomicReferenceArray<Detour> ways = kept[type];
        if (all) {
            Detour way = ways.getAcquire(from * places + to);
            return way == null ? findAll(type, from, to) : way;
        }
        int slot = slot(from, to);
        Detour way = ways.getAcquire(slot);
        if (way == null || way.from() != from || way.to() != to) {
            way = guides[type].find(from, to);
            ways.setRelease(slot, way);
        }
        return way;
    }

    private Detour findAll(int type, int from, int to) {
        Detour way = guides[type].find(from, to);
        Detour shared = way.costs() == null ? STRAIGHT : way;
        kept[type].setRelease(from * places + to, shared);
        return shared;
    }

    private int slot(int from, int to) {
        int mixed = (from * 0x9E3779B1) ^ (to * 0x85EBCA6B);
        return (mixed ^ mixed >>> 15) & (room - 1);
    }

    @Override
    public int places() {
        return places;
    }

    @Override
    public double eastMeters(int place) {
        return open.eastMeters(place);
    }

    @Override
    public double northMeters(int place) {
        return open.northMeters(place);
    }

    @Override
    public double seconds(int type, int from, int to) {
        Detour.CostsByType costs = find(type, from, to).costs();
        return costs == null ? open.seconds(type, from, to) : costs.seconds[type];
    }

    @Override
    public double meters(int type, int from, int to) {
        Detour.CostsByType costs = find(type, from, to).costs();
        return costs == null ? open.meters(type, from, to) : costs.meters;
    }

    @Override
    public double joules(int type, int from, int to) {
        Detour.CostsByType costs = find(type, from, to).costs();
        return costs == null ? open.joules(type, from, to) : costs.joules[type];
    }

    @Override
    public List<Geodetic> between(int type, int from, int to) {
        return find(type, from, to).turns();
    }

    @Override
    public @Nullable String obstacle(int type, int waypoint) {
        return guides[type].obstacle(waypoint);
    }
}
