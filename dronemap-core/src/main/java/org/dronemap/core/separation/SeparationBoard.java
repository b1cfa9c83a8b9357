package org.dronemap.core.separation;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import org.dronemap.core.drone.DroneId;

/** Exchange between operations, which say what they mean to do, and the guard, which says who gives way. Any thread. */
public final class SeparationBoard {
    private final Map<String, Map<DroneId, FlightIntent>> intents = new ConcurrentHashMap<>();
    private final LongAdder rounds = new LongAdder();
    private volatile Set<String> unplanned = Set.of();
    private volatile Map<DroneId, GiveWay> giveWays = Map.of();
    private volatile Map<DroneId, List<PossiblePlace>> silent = Map.of();

    /** What one of them means its drones to do from now on, in the place of what it meant before. */
    public void intend(String operation, Map<DroneId, FlightIntent> next) {
        if (next.isEmpty()) {
            intents.remove(operation);
        } else {
            intents.put(operation, Map.copyOf(next));
        }
    }

    /** Of all operations; a drone is in the hand of one of them at most. */
    public Map<DroneId, FlightIntent> intents() {
        Map<DroneId, FlightIntent> all = new HashMap<>();
        intents.values().forEach(all::putAll);
        return all;
    }

    /** These operations have several drones, which no plan keeps apart: each is to the others as a stranger's. */
    public void unplanned(Set<String> operations) {
        unplanned = Set.copyOf(operations);
    }

    /** Whether the drones of that operation were planned together. */
    public boolean isPlanned(String operation) {
        return !unplanned.contains(operation);
    }

    public void publish(Map<DroneId, GiveWay> next, Map<DroneId, List<PossiblePlace>> unheard) {
        giveWays = Map.copyOf(next);
        rounds.increment();
        silent = Map.copyOf(unheard);
    }

    /** Where each drone that is not heard may be now; nowhere: it must be down. */
    public Map<DroneId, List<PossiblePlace>> silent() {
        return silent;
    }

    /** How often the guard has looked; 0: nobody keeps drones apart here. */
    public long rounds() {
        return rounds.sum();
    }

    /** To whom drones give way now. Read before the drones' states: who was sent on is shown so by then. */
    public Map<DroneId, GiveWay> giveWays() {
        return giveWays;
    }

    public Optional<GiveWay> giveWay(DroneId drone) {
        return Optional.ofNullable(giveWays.get(drone));
    }
}
