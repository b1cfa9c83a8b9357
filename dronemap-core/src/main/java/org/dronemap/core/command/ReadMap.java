package org.dronemap.core.command;

/** Ask the vehicle for the map that it goes by. */
public record ReadMap() implements Command.Apart {
    @Override
    public CommandKind kind() {
        return CommandKind.READ_MAP;
    }

    @Override
    public String summary() {
        return "read its map";
    }
}
