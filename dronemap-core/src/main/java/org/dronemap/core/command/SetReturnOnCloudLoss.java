package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Come home by itself when the cloud falls silent while it waits for what it is led by; what its owner set for that stays. */
@Stored(as = "ReturnOnLoss")
public record SetReturnOnCloudLoss() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.RETURN_ON_LOSS;
    }

    @Override
    public String summary() {
        return "come home when the cloud is lost";
    }
}
