package org.dronemap.core.command;

import java.util.List;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.stored.Stored;

/**
 * Command to a vehicle: set its fail-safe so that it returns or lands by itself on loss of the cloud. What the owner
 * had set is kept before anything is written.
 *
 * @param afterSeconds so long it shall wait, where that concerns nothing but the cloud
 * @param kept from earlier: where the vehicle shows what the cloud had written, the owner's value is still that of then
 */
@Stored(as = "SetCloudLoss", names = "afterSeconds kept keeper")
public record SetCloudLossAction(int afterSeconds, List<OverriddenParameter> kept, ParameterOverrideRecorder keeper)
        implements Command.Standalone {
    public SetCloudLossAction {
        kept = List.copyOf(kept);
    }

    @Override
    public CommandKind kind() {
        return CommandKind.SET_CLOUD_LOSS;
    }

    @Override
    public String summary() {
        return "set what it does without the cloud";
    }
}
