package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;

/** A vehicle's side of the parameter protocol, as autopilots do it: silent about names that it does not have. */
final class ParameterVehicle {
    final Map<String, Parameter> held = new LinkedHashMap<>();
    final ParameterCodec codec;
    String altered = "";

    ParameterVehicle(boolean bytewise) {
        codec = new ParameterCodec(bytewise);
    }

    static ParameterVehicle with(int count, boolean bytewise) {
        ParameterVehicle vehicle = new ParameterVehicle(bytewise);
        for (int number = 0; number < count; number++) {
            ParameterType type = number % 3 == 0 ? ParameterType.REAL32 : ParameterType.INT32;
            String name = "P_" + number;
            vehicle.held.put(name, new Parameter(name, type, type.held(number * 1.5)));
        }
        return vehicle;
    }

    void take(TestWire wire, Message message) {
        List<String> names = new ArrayList<>(held.keySet());
        if (message instanceof ParamRequestList) {
            names.forEach(name -> tell(wire, name));
        } else if (message instanceof ParamRequestRead read) {
            if (read.paramIndex() >= 0 && read.paramIndex() < names.size()) {
                tell(wire, names.get(read.paramIndex()));
            } else if (held.containsKey(read.paramId())) {
                tell(wire, read.paramId());
            }
        } else if (message instanceof ParamSet set && held.containsKey(set.paramId())) {
            ParameterType type = ParameterCodec.type(set.paramType());
            Parameter told = new Parameter(set.paramId(), type, codec.decode(type, set.paramValue()));
            held.put(told.name(), told);
            tell(wire, told.name());
            if (told.name().equals(altered)) {
                held.put(told.name(), told.withValue(told.value() + 1));
            }
        }
    }

    private void tell(TestWire wire, String name) {
        Parameter parameter = held.get(name);
        if (parameter != null) {
            wire.answer(new ParamValue(
                    name,
                    codec.encode(parameter.type(), parameter.value()),
                    ParameterCodec.number(parameter.type()),
                    held.size(),
                    List.copyOf(held.keySet()).indexOf(name)));
        }
    }
}
