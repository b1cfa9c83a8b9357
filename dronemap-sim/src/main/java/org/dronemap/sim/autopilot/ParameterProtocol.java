package org.dronemap.sim.autopilot;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.sim.flight.SimulatedParameters;

/** A simulated vehicle's side of the MAVLink parameter protocol; requests for unknown names stay unanswered. */
final class ParameterProtocol {
    private static final int PER_STEP = 4;

    private final SimulatedAutopilot autopilot;
    private final SimulatedParameters parameters;
    private final boolean bytewise;
    private final SimulatedStorageFaults alterations;
    private final Consumer<Message> out;
    private int listed;

    ParameterProtocol(SimulatedAutopilot autopilot, SimulatedStorageFaults alterations, Consumer<Message> out) {
        this.autopilot = autopilot;
        this.alterations = alterations;
        this.parameters = autopilot.parameters();
        this.bytewise = autopilot.parametersAsBits();
        this.out = out;
        this.listed = parameters.size();
    }

    void list() {
        listed = 0;
    }

    /** A list goes out a few at a time, so that it does not overrun a slow link. */
    void step() {
        for (int i = 0; i < PER_STEP && listed < parameters.size(); i++) {
            send(listed++);
        }
    }

    void read(ParamRequestRead request) {
        int index = request.paramIndex() >= 0 ? request.paramIndex() : parameters.indexOf(request.paramId());
        if (index >= 0 && index < parameters.size()) {
            send(index);
        }
    }

    void write(ParamSet request) {
        int index = parameters.indexOf(request.paramId());
        if (index < 0 || (Float.isNaN(request.paramValue()) && !bytewise)) {
            return;
        }
        boolean asBits = bytewise && parameters.at(index).type() != SimulatedParameters.REAL32;
        double value = asBits ? Float.floatToRawIntBits(request.paramValue()) : request.paramValue();
        parameters.set(request.paramId(), value);
        send(index);
        parameters.set(request.paramId(), alterations.kept(request.paramId(), value));
        autopilot.parameterChanged(request.paramId());
    }

    private void send(int index) {
        SimulatedParameters.Parameter parameter = parameters.at(index);
        boolean asBits = bytewise && parameter.type() != SimulatedParameters.REAL32;
        float value = asBits ? Float.intBitsToFloat((int) parameter.value()) : (float) parameter.value();
        out.accept(new ParamValue(parameter.name(), value, parameter.type(), parameters.size(), index));
    }
}
