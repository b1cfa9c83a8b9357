package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.mission.Altitude;

/**
 * Groups the drones of a planning problem into types with the same performance and the same barriers. Never changes.
 */
final class DroneTypes {
    private final int[] types;
    private final FlightModel[] paces;
    private final List<BarrierSet> regions;

    private DroneTypes(int[] types, FlightModel[] paces, List<BarrierSet> regions) {
        this.types = types;
        this.paces = paces;
        this.regions = regions;
    }

    /**
     * Barriers as a group of drones sees them.
     *
     * @param homeAmslMeters what bands above home are counted from; 0 where none is
     */
    record BarrierSet(List<Barrier> barriers, double homeAmslMeters) {}

    private record Type(Performance performance, BarrierSet region) {}

    static DroneTypes of(PlanningProblem problem) {
        Map<Type, Integer> known = new LinkedHashMap<>();
        Map<BarrierSet, BarrierSet> regions = new LinkedHashMap<>();
        int[] types = new int[problem.crafts().size()];
        for (int r = 0; r < types.length; r++) {
            Craft craft = problem.crafts().get(r);
            BarrierSet seen = region(problem, craft);
            BarrierSet region = regions.computeIfAbsent(seen, same -> same);
            Type type = new Type(craft.performance(), region);
            Integer number = known.putIfAbsent(type, known.size());
            types[r] = number == null ? known.size() - 1 : number;
        }
        List<FlightModel> paces = new ArrayList<>();
        known.keySet().forEach(type -> paces.add(new FlightModel(type.performance(), problem.wind())));
        return new DroneTypes(
                types,
                paces.toArray(FlightModel[]::new),
                known.keySet().stream().map(Type::region).toList());
    }

    private static BarrierSet region(PlanningProblem problem, Craft craft) {
        List<Barrier> binding = problem.barriers().stream()
                .filter(barrier -> barrier.binds(craft.id()))
                .toList();
        boolean fromHome = binding.stream()
                .anyMatch(
                        barrier -> barrier.band().isBounded() && barrier.band().reference() == Altitude.Reference.HOME);
        return new BarrierSet(binding, fromHome ? craft.homeAmslMeters() : 0);
    }

    int typeOf(int drone) {
        return types[drone];
    }

    /** Of each type; not to be written to. */
    FlightModel[] paces() {
        return paces;
    }

    /** What binds each type; types may share one. */
    List<BarrierSet> regions() {
        return regions;
    }

    FlightModel paceOf(int drone) {
        return paces[types[drone]];
    }
}
