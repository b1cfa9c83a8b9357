package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Stand still at once, and give up whatever it was driving to. */
@Stored(as = "EmergencyStop")
public record EmergencyStop() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.EMERGENCY_STOP;
    }

    @Override
    public String summary() {
        return "stop at once";
    }
}
