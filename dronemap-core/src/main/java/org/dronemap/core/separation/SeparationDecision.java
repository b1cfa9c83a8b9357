package org.dronemap.core.separation;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;

/**
 * Decision on one picture of the airspace.
 *
 * @param yielding who gives way
 * @param orders what is commanded for that now
 * @param silent where each drone that is not heard may be now
 */
public record SeparationDecision(
        Map<DroneId, Yielding> yielding, List<SeparationOrder> orders, Map<DroneId, List<PossiblePlace>> silent) {
    public SeparationDecision {
        yielding = Map.copyOf(yielding);
        orders = List.copyOf(orders);
        silent = Map.copyOf(silent);
    }

    /** What operations are shown: whoever waited on the ground, and may rise now, waits for nobody. */
    public Map<DroneId, GiveWay> giveWays() {
        return yielding.entrySet().stream()
                .filter(entry -> !entry.getValue().mayRise())
                .collect(Collectors.toUnmodifiableMap(
                        Map.Entry::getKey, entry -> entry.getValue().give()));
    }
}
