package org.dronemap.cognitive.operation.recovery;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.separation.VerticalMargin;

/**
 * Orders the moves of all drones, and says which of them wait for which.
 *
 * <p>All moves stand in one order: all changes of height, then all ways home, then all descents, the lowest first. Of two
 * moves that would come too near, the later one waits until the earlier one is done, and its drone gone from where it then
 * stands. So the order by itself is one way to carry all of it out, and drones that do not wait for each other may move at
 * the same time, however fast each is.
 */
final class RecoverySchedule {
    /** Two that stand too near to each other already do not come nearer. */
    private static final double AS_NOW = 0.99;

    private final RecoveryOrder order;
    private final List<RecoveryRoute> routes;
    private final List<Move> moves = new ArrayList<>();
    private final Map<Move, Integer> places = new HashMap<>();

    /** One drone in one step in which it moves. */
    record Move(RecoveryRoute route, RecoveryStep step) {}

    /** {@code one} would have to move through where {@code other} stands. */
    record Blocked(RecoveryRoute one, RecoveryRoute other) {}

    RecoverySchedule(RecoveryOrder order, List<RecoveryRoute> routes) {
        this.order = order;
        this.routes = routes.stream()
                .sorted(Comparator.comparingDouble(RecoveryRoute::layerMeters)
                        .thenComparing(route -> route.drone().drone().value()))
                .toList();
        levelling().forEach(route -> moves.add(new Move(route, RecoveryStep.LEVELLING)));
        this.routes.forEach(route -> moves.add(new Move(route, RecoveryStep.UNDER_WAY)));
        this.routes.forEach(route -> moves.add(new Move(route, RecoveryStep.DESCENDING)));
        moves.forEach(move -> places.put(move, places.size()));
    }

    /** In an order in which nobody changes height through another one. */
    private List<RecoveryRoute> levelling() {
        List<RecoveryRoute> left = new ArrayList<>(routes);
        List<RecoveryRoute> ordered = new ArrayList<>();
        while (!left.isEmpty()) {
            RecoveryRoute next = left.stream()
                    .filter(route -> left.stream()
                                    .noneMatch(
                                            other -> conflict(route, RecoveryStep.LEVELLING, other, RecoveryStep.ALOFT))
                            && ordered.stream()
                                    .noneMatch(other ->
                                            conflict(route, RecoveryStep.LEVELLING, other, RecoveryStep.LEVEL)))
                    .findFirst()
                    .orElse(left.get(0));
            left.remove(next);
            ordered.add(next);
        }
        return ordered;
    }

    private boolean conflict(RecoveryRoute one, RecoveryStep mine, RecoveryRoute other, RecoveryStep theirs) {
        return !one.isSame(other) && clearance(one, mine, other, theirs) < least(one, other);
    }

    private double least(RecoveryRoute one, RecoveryRoute other) {
        return Math.min(1, AS_NOW * clearance(one, RecoveryStep.ALOFT, other, RecoveryStep.ALOFT));
    }

    private double clearance(RecoveryRoute one, RecoveryStep mine, RecoveryRoute other, RecoveryStep theirs) {
        double above = order.apart().verticalMeters()
                + VerticalMargin.between(one.drone().home(), other.drone().home());
        return one.box(mine).clearance(other.box(theirs), order.apart().horizontalMeters(), above);
    }

    private boolean isBefore(RecoveryRoute one, RecoveryStep step, Move move) {
        return places.getOrDefault(new Move(one, step), 0) < places.getOrDefault(move, 0);
    }

    /** How far the other one has to be before that move; empty: wherever it is. */
    private Optional<RecoveryStep> needed(Move move, RecoveryRoute other) {
        RecoveryStep needed = RecoveryStep.ALOFT;
        for (RecoveryStep theirs = RecoveryStep.ALOFT; theirs != RecoveryStep.DOWN; theirs = theirs.next()) {
            RecoveryStep arrived = theirs.isMove() || theirs == RecoveryStep.ALOFT ? theirs : theirs.before();
            boolean first = theirs == RecoveryStep.ALOFT || isBefore(other, arrived, move);
            if (first && conflict(move.route(), move.step(), other, theirs)) {
                needed = theirs.next();
            }
        }
        return needed == RecoveryStep.ALOFT ? Optional.empty() : Optional.of(needed);
    }

    /** For whom each drone waits, in each of its steps. */
    Map<DroneId, List<RecoveryWait>> waits() {
        Map<DroneId, List<RecoveryWait>> waits = new HashMap<>();
        for (RecoveryRoute route : routes) {
            List<RecoveryWait> own = new ArrayList<>();
            for (RecoveryRoute other : routes) {
                RecoveryStep known = RecoveryStep.ALOFT;
                for (RecoveryStep step : RecoveryStep.MOVES) {
                    RecoveryStep needed = needed(new Move(route, step), other).orElse(RecoveryStep.ALOFT);
                    if (!other.isSame(route) && known.isBefore(needed)) {
                        own.add(new RecoveryWait(step, other.drone().drone(), needed));
                        known = needed;
                    }
                }
            }
            waits.put(route.drone().drone(), own);
        }
        return waits;
    }

    /** Carries all moves out one after the other; the first that cannot be. */
    Optional<Blocked> blocked() {
        Map<RecoveryRoute, RecoveryStep> now = new HashMap<>();
        routes.forEach(route -> now.put(route, RecoveryStep.ALOFT));
        for (Move move : moves) {
            for (RecoveryRoute other : routes) {
                RecoveryStep theirs = now.getOrDefault(other, RecoveryStep.ALOFT);
                if (theirs != RecoveryStep.DOWN && conflict(move.route(), move.step(), other, theirs)) {
                    return Optional.of(new Blocked(move.route(), other));
                }
            }
            now.put(move.route(), move.step().next());
        }
        return Optional.empty();
    }

    /** When each drone begins and ends its moves, in seconds from now, if all goes as is reckoned. */
    Map<DroneId, Map<RecoveryStep, Double>> times(Map<DroneId, List<RecoveryWait>> waits) {
        Map<DroneId, Map<RecoveryStep, Double>> times = new HashMap<>();
        routes.forEach(route -> times.put(route.drone().drone(), new EnumMap<>(Map.of(RecoveryStep.ALOFT, 0.0))));
        for (Move move : moves) {
            DroneId id = move.route().drone().drone();
            Map<RecoveryStep, Double> own = times.getOrDefault(id, Map.of());
            double begin = own.getOrDefault(move.step().before(), 0.0);
            for (RecoveryWait wait : waits.getOrDefault(id, List.of())) {
                if (wait.step() == move.step()) {
                    begin = Math.max(
                            begin, times.getOrDefault(wait.other(), Map.of()).getOrDefault(wait.reached(), 0.0));
                }
            }
            own.put(move.step(), begin);
            own.put(move.step().next(), begin + move.route().seconds(move.step()));
        }
        return times;
    }
}
