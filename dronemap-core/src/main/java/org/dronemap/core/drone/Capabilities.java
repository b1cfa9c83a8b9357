package org.dronemap.core.drone;

import java.util.List;
import java.util.Set;

/**
 * What one vehicle can do, as the adapter of its autopilot declares it.
 *
 * @param modes flight modes that can be set by name
 * @param known false until the adapter declared it
 */
public record Capabilities(Set<Capability> commands, List<String> modes, boolean known) {
    public static final Capabilities NONE = new Capabilities(Set.of(), List.of());
    /** Of a vehicle that was not asked yet. */
    public static final Capabilities UNKNOWN = new Capabilities(Set.of(), List.of(), false);

    public Capabilities {
        commands = Set.copyOf(commands);
        modes = List.copyOf(modes);
    }

    public Capabilities(Set<Capability> commands, List<String> modes) {
        this(commands, modes, true);
    }
}
