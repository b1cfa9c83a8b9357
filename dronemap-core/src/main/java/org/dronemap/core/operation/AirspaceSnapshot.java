package org.dronemap.core.operation;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.PossiblePlace;
import org.dronemap.core.zone.Zone;

/**
 * Zones and other flying drones around an operation's drones, for guidance to keep clear of.
 *
 * @param zones that bind each drone now or soon
 * @param traffic all others that are in the air, or were when they were heard last
 * @param silent where others that are not heard any more may be now; they are not among the traffic
 * @param steered all that an operation steers now, its own among them: each is kept apart from others by whoever does
 */
public record AirspaceSnapshot(
        Map<DroneId, List<Zone>> zones, List<DroneState> traffic, List<PossiblePlace> silent, Set<DroneId> steered) {
    public static final AirspaceSnapshot NONE = new AirspaceSnapshot(Map.of(), List.of(), List.of(), Set.of());

    public AirspaceSnapshot {
        zones = Map.copyOf(zones);
        traffic = List.copyOf(traffic);
        silent = List.copyOf(silent);
        steered = Set.copyOf(steered);
    }
}
