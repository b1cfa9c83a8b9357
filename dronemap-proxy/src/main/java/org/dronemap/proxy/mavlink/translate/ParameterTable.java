package org.dronemap.proxy.mavlink.translate;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.ParameterCodec;
import org.jspecify.annotations.Nullable;

/**
 * The parameters that one vehicle has reported to the server; publishes each change as a drone event. Owned by the
 * drone's lane.
 */
public final class ParameterTable {
    private static final int MOST = 10_000;

    private final ParameterCodec codec;
    private final Consumer<DroneEvent> out;
    private final Map<String, Parameter> parameters = new HashMap<>();
    private boolean whole;

    public ParameterTable(AutopilotAdapter autopilot, Consumer<DroneEvent> out) {
        this.codec = new ParameterCodec(autopilot.parametersAsBits());
        this.out = out;
    }

    ParameterCodec codec() {
        return codec;
    }

    /** As last heard; null when it never was. */
    @Nullable
    Parameter find(String name) {
        return parameters.get(name);
    }

    public void received(Frame frame) {
        if (frame.messageId() != ParamValue.ID) {
            return;
        }
        Parameter now = codec.decode(ParamValue.decode(frame));
        if (now.name().isEmpty() || (parameters.size() >= MOST && !parameters.containsKey(now.name()))) {
            return;
        }
        Parameter before = parameters.put(now.name(), now);
        // Until the list is whole, single ones are no news: a part would look like all.
        if (whole && !now.equals(before)) {
            out.accept(new DroneEvent.ParameterReported(now));
        }
    }

    /** The whole list was read. */
    void read(List<Parameter> all) {
        whole = true;
        parameters.clear();
        all.forEach(parameter -> parameters.put(parameter.name(), parameter));
        out.accept(new DroneEvent.ParametersRead(all));
    }
}
