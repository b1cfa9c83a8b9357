package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.core.mission.Altitude;

/** Groups drones into types: those of one type have the same performance and the same barriers. Never changes. */
final class Fleet {
    private final int[] types;
    private final Pace[] paces;
    private final List<Region> regions;

    private Fleet(int[] types, Pace[] paces, List<Region> regions) {
        this.types = types;
        this.paces = paces;
        this.regions = regions;
    }

    /**
     * Barriers as a group of drones sees them.
     *
     * @param homeAmslMeters what bands above home are counted from; 0 where none is
     */
    record Region(List<Barrier> barriers, double homeAmslMeters) {}

    private record Type(Performance performance, Region region) {}

    static Fleet of(Problem problem) {
        Map<Type, Integer> known = new LinkedHashMap<>();
        Map<Region, Region> regions = new LinkedHashMap<>();
        int[] types = new int[problem.crafts().size()];
        for (int r = 0; r < types.length; r++) {
            Craft craft = problem.crafts().get(r);
            Region seen = region(problem, craft);
            Region region = regions.computeIfAbsent(seen, same -> same);
            Type type = new Type(craft.performance(), region);
            Integer number = known.putIfAbsent(type, known.size());
            types[r] = number == null ? known.size() - 1 : number;
        }
        List<Pace> paces = new ArrayList<>();
        known.keySet().forEach(type -> paces.add(new Pace(type.performance(), problem.wind())));
        return new Fleet(
                types,
                paces.toArray(Pace[]::new),
                known.keySet().stream().map(Type::region).toList());
    }

    private static Region region(Problem problem, Craft craft) {
        List<Barrier> binding = problem.barriers().stream()
                .filter(barrier -> barrier.binds(craft.id()))
                .toList();
        boolean fromHome = binding.stream()
                .anyMatch(
                        barrier -> barrier.band().isBounded() && barrier.band().reference() == Altitude.Reference.HOME);
        return new Region(binding, fromHome ? craft.homeAmslMeters() : 0);
    }

    int typeOf(int drone) {
        return types[drone];
    }

    /** Of each type; not to be written to. */
    Pace[] paces() {
        return paces;
    }

    /** What binds each type; types may share one. */
    List<Region> regions() {
        return regions;
    }

    Pace paceOf(int drone) {
        return paces[types[drone]];
    }
}
