package org.dronemap.core.command;

import org.dronemap.core.drone.Capability;

/** Stand still at once, and give up whatever it was driving to. */
public record EmergencyStop() implements Command.Apart {
    @Override
    public Capability needs() {
        return Capability.EMERGENCY_STOP;
    }

    @Override
    public String summary() {
        return "stop at once";
    }
}
