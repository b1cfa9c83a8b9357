package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a robot: send the map that it navigates by. */
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
