package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Ask the vehicle for the map that it goes by. */
@Stored(as = "ReadMap")
public record ReadMap() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.READ_MAP;
    }

    @Override
    public String summary() {
        return "read its map";
    }
}
