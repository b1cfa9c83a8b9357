package org.dronemap.core.command;

/** Stand still at once, and give up whatever it was driving to. */
public record EmergencyStop() implements Command.Apart {
    @Override
    public CommandKind kind() {
        return CommandKind.EMERGENCY_STOP;
    }

    @Override
    public String summary() {
        return "stop at once";
    }
}
