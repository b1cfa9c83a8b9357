package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a vehicle: stop at once and drop its current goal. */
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
