package org.dronemap.core.separation;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;

/** What follows from a picture of the airspace: who gives way, and what is commanded for that now. */
public record SeparationDecision(Map<DroneId, Yielding> yielding, List<SeparationOrder> orders) {
    public SeparationDecision {
        yielding = Map.copyOf(yielding);
        orders = List.copyOf(orders);
    }

    /** What operations are shown. */
    public Map<DroneId, GiveWay> giveWays() {
        return yielding.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(
                        Map.Entry::getKey, entry -> entry.getValue().give()));
    }
}
