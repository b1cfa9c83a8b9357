package org.dronemap.core.command;

import org.dronemap.core.drone.Capability;

/** Ask the vehicle for the map that it goes by. */
public record ReadMap() implements Command.Apart {
    @Override
    public Capability needs() {
        return Capability.READ_MAP;
    }

    @Override
    public String summary() {
        return "read its map";
    }
}
