package org.dronemap.core.drone;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What one vehicle can do, as the adapter of its autopilot declares it.
 *
 * @param modes flight modes that can be set by name
 * @param steering who steers in a mode; in one that is not there the vehicle flies by itself
 * @param known false until the adapter declared it
 */
public record Capabilities(
        Set<Capability> commands, List<String> modes, Map<String, Steering> steering, boolean known) {
    public static final Capabilities NONE = new Capabilities(Set.of(), List.of());
    /** Of a vehicle that was not asked yet. */
    public static final Capabilities UNKNOWN = new Capabilities(Set.of(), List.of(), Map.of(), false);

    /** Who steers where the vehicle does not fly by itself. */
    public enum Steering {
        /** A pilot's sticks. */
        STICKS,
        /** Whoever gives orders; it waits for them. */
        ORDERS
    }

    public Capabilities {
        commands = Set.copyOf(commands);
        modes = List.copyOf(modes);
        steering = Map.copyOf(steering);
    }

    public Capabilities(Set<Capability> commands, List<String> modes, Map<String, Steering> steering) {
        this(commands, modes, steering, true);
    }

    /** Of a vehicle whose modes say nothing of who steers. */
    public Capabilities(Set<Capability> commands, List<String> modes) {
        this(commands, modes, Map.of());
    }
}
