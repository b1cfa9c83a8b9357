package org.dronemap.core.command;

import org.dronemap.core.drone.Capability;

/** Come home by itself when the cloud falls silent while it waits for what it is led by; what its owner set for that stays. */
public record ReturnOnLoss() implements Command.Apart {
    @Override
    public Capability needs() {
        return Capability.SET_PARAMETERS;
    }

    @Override
    public String summary() {
        return "come home when the cloud is lost";
    }
}
