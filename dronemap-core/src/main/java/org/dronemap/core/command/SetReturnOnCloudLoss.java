package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a following drone: return home by itself if the cloud is lost while it waits for guidance. */
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
