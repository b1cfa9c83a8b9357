package org.dronemap.ws.violation;

import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;

/** Forgets all commands but two, and knows what a mode of one autopilot is called. */
public final class CaseViolations {
    public String chain(Command command) {
        if (command instanceof Command.Land) {
            return "LAND";
        }
        return command instanceof Command.Hold ? "still" : "";
    }

    public boolean swallows(CommandKind kind) {
        return switch (kind) {
            case LAND, HOLD -> true;
            default -> false;
        };
    }
}
