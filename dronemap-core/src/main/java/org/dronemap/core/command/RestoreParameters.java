package org.dronemap.core.command;

import java.util.List;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.stored.Stored;

/** Command to a vehicle: restore the owner's values of parameters that the cloud has overridden. */
@Stored(as = "PutBack", names = "values keeper")
public record RestoreParameters(List<OverriddenParameter> values, ParameterOverrideRecorder keeper)
        implements Command.Standalone {
    public RestoreParameters {
        values = List.copyOf(values);
    }

    @Override
    public CommandKind kind() {
        return CommandKind.PUT_BACK;
    }

    @Override
    public String summary() {
        return "put back what its owner had set";
    }
}
