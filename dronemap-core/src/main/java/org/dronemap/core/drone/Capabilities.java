package org.dronemap.core.drone;

import java.util.List;
import java.util.Set;

/** What one vehicle can do, as the adapter of its autopilot declares it; {@code modes} can be set by name. */
public record Capabilities(Set<Capability> commands, List<String> modes) {
    public static final Capabilities NONE = new Capabilities(Set.of(), List.of());

    public Capabilities {
        commands = Set.copyOf(commands);
        modes = List.copyOf(modes);
    }
}
