package org.dronemap.core.command;

import java.util.List;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.stored.Stored;

/**
 * Have the vehicle come home or down by itself when it does not hear the cloud any more, as far as its owner has not set
 * something like it; loosens nothing. What the owner had set is kept before anything is written.
 *
 * @param afterSeconds so long it shall wait, where that concerns nothing but the cloud
 * @param kept from earlier: where the vehicle shows what the cloud had written, the owner's value is still that of then
 */
@Stored(as = "SetCloudLoss", names = "afterSeconds kept keeper")
public record SetCloudLoss(int afterSeconds, List<OverriddenParameter> kept, ParameterOverrideRecorder keeper)
        implements Command.Standalone {
    public SetCloudLoss {
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
